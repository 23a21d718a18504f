//! The pages of the book, and what is code in them.

use super::common::root;

/// A fenced block.
pub(crate) struct Block {
    /// Its page, from the root of the workspace.
    pub(crate) page: String,
    /// Line of the fence, counted from 1.
    pub(crate) line: usize,
    /// What stands behind the opening fence.
    pub(crate) kind: String,
    pub(crate) text: String,
}

/// The pages, from the root of the workspace.
pub(crate) fn pages() -> Vec<String> {
    let docs = std::fs::read_dir(root().join("docs")).unwrap();
    let names = docs.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut pages: Vec<String> =
        names.filter(|name| name.ends_with(".md")).map(|name| format!("docs/{name}")).collect();
    pages.sort();
    pages.extend(["README.md", "ARCHITECTURE.md", "CHANGELOG.md"].map(str::to_owned));
    pages
}

/// The text of a page.
pub(crate) fn read(page: &str) -> String {
    std::fs::read_to_string(root().join(page)).unwrap()
}

/// All blocks of all pages.
pub(crate) fn blocks() -> Vec<Block> {
    pages().iter().flat_map(|page| split(page).0).collect()
}

/// What a page has between backticks within its text, in one line.
pub(crate) fn code_spans(page: &str) -> impl Iterator<Item = String> {
    let text = split(page).1;
    let paragraphs: Vec<String> = text.split("\n\n").map(str::to_owned).collect();
    paragraphs.into_iter().flat_map(|paragraph| {
        let spans = paragraph.split('`').skip(1).step_by(2);
        spans.map(|span| span.split_whitespace().collect::<Vec<_>>().join(" ")).collect::<Vec<_>>()
    })
}

/// The blocks of a page, and the text around them.
pub(crate) fn split(page: &str) -> (Vec<Block>, String) {
    let (mut blocks, mut around) = (Vec::<Block>::new(), String::new());
    let mut inside = false;
    for (number, line) in read(page).lines().enumerate() {
        match line.trim_start().strip_prefix("```") {
            Some("") if inside => inside = false,
            Some(kind) => {
                assert!(!inside, "{page}:{}: a block begins within a block", number + 1);
                inside = true;
                let (page, kind) = (page.to_owned(), kind.to_owned());
                blocks.push(Block { page, line: number + 1, kind, text: String::new() });
            }
            None if inside => {
                let text = &mut blocks.last_mut().unwrap().text;
                text.push_str(line);
                text.push('\n');
            }
            None => {
                around.push_str(line);
                around.push('\n');
            }
        }
    }
    assert!(!inside, "{page}: a block does not end");
    (blocks, around)
}
