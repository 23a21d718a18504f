//! Whether links lead to files and headings that are there.

use super::blocks::{read, split};
use super::common::root;

/// Links of a page that lead nowhere.
pub(crate) fn faults(page: &str) -> Vec<String> {
    let here = std::path::Path::new(page).parent().unwrap();
    let text = split(page).1;
    let links = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    links
        .filter(|link| !link.contains("://"))
        .filter_map(|link| {
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { page.into() } else { here.join(file) };
            if !root().join(&target).exists() {
                return Some(format!("{page} links to {file}, which is not there"));
            }
            let known =
                heading.is_empty() || anchors(target.to_str().unwrap()).any(|anchor| anchor == heading);
            (!known).then(|| format!("{page} links to {link}, and there is no such heading"))
        })
        .collect()
}

/// What the headings of a page are called in links: small letters, hyphens for spaces, nothing else but letters, digits and
/// underscores.
fn anchors(page: &str) -> impl Iterator<Item = String> {
    let headings: Vec<String> =
        read(page).lines().filter(|line| line.starts_with('#')).map(str::to_owned).collect();
    headings.into_iter().map(|line| {
        let title = line.trim_start_matches('#').trim().to_lowercase();
        let kept = title.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
        kept.map(|c| if c == ' ' { '-' } else { c }).collect()
    })
}
