//! VTK files are read back by a small decoder of its own, written from the description of the format.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on should fail")]

mod common;

use std::io::Read;
use std::path::Path;

use common::{directory, listing};
use flate2::read::ZlibDecoder;
use mps_io::{FieldFormat, FieldOptions, FieldWriter, OutputError, PointCloud};
use mps_kernel::{Real, Tensor, Vector};

/// A frame as text and bytes.
struct Frame {
    xml: String,
    appended: Vec<u8>,
}

/// One array of a frame.
struct Array {
    kind: String,
    components: usize,
    bytes: Vec<u8>,
}

impl Frame {
    fn read(path: &Path) -> Self {
        let bytes = std::fs::read(path).unwrap();
        let mark = b"<AppendedData encoding=\"raw\">\n_";
        let at = bytes.windows(mark.len()).position(|w| w == mark).unwrap();
        let xml = String::from_utf8(bytes[..at].to_vec()).unwrap();
        let tail = b"\n  </AppendedData>\n</VTKFile>\n";
        assert!(bytes.ends_with(tail));
        Self { xml, appended: bytes[at + mark.len()..bytes.len() - tail.len()].to_vec() }
    }

    fn array(&self, name: &str) -> Array {
        let tag = format!("Name=\"{name}\"");
        let line = self.xml.lines().find(|line| line.contains(&tag)).unwrap_or_else(|| panic!("no {name}"));
        let offset: usize = attribute(line, "offset").parse().unwrap();
        let data = &self.appended[offset..];
        let bytes = if self.xml.contains("vtkZLibDataCompressor") { inflate(data) } else { raw(data) };
        let components = attribute(line, "NumberOfComponents").parse().unwrap();
        Array { kind: attribute(line, "type"), components, bytes }
    }
}

impl Array {
    fn doubles(&self) -> Vec<f64> {
        assert_eq!(self.kind, "Float64");
        self.bytes.as_chunks().0.iter().map(|b| f64::from_le_bytes(*b)).collect()
    }

    fn singles(&self) -> Vec<f32> {
        assert_eq!(self.kind, "Float32");
        self.bytes.as_chunks().0.iter().map(|b| f32::from_le_bytes(*b)).collect()
    }
}

fn attribute(line: &str, name: &str) -> String {
    let start = line.find(&format!(" {name}=\"")).unwrap() + name.len() + 3;
    line[start..].split('"').next().unwrap().to_owned()
}

fn number(data: &[u8], k: usize) -> usize {
    u64::from_le_bytes(data[8 * k..8 * k + 8].try_into().unwrap()) as usize
}

fn raw(data: &[u8]) -> Vec<u8> {
    data[8..8 + number(data, 0)].to_vec()
}

fn inflate(data: &[u8]) -> Vec<u8> {
    let (blocks, full, last) = (number(data, 0), number(data, 1), number(data, 2));
    assert!(last < full, "a full last block is written as 0");
    let mut at = 8 * (3 + blocks);
    let mut bytes = Vec::new();
    for k in 0..blocks {
        let length = number(data, 3 + k);
        let mut block = Vec::new();
        ZlibDecoder::new(&data[at..at + length]).read_to_end(&mut block).unwrap();
        assert_eq!(block.len(), if k + 1 == blocks && last > 0 { last } else { full });
        bytes.extend(block);
        at += length;
    }
    bytes
}

/// Values with all kinds of bits: signs, tiny, huge, not finite.
fn awkward<T: Real>(k: usize) -> T {
    match k % 7 {
        0 => T::of(1.0 / 3.0 + k as f64),
        1 => T::of(-1e-30),
        2 => T::of(-0.0),
        3 => T::of(f64::NAN),
        4 => T::of(f64::INFINITY),
        5 => T::of(1e30),
        _ => T::of((k as f64).sqrt()),
    }
}

fn options(compress: bool, single_precision: bool) -> FieldOptions {
    FieldOptions { compress, single_precision, ..FieldOptions::default() }
}

/// Writes a frame of `n` particles and compares every value after `expected` bit for bit.
fn round_trip<T: Real, const D: usize>(name: &str, n: usize, options: FieldOptions) {
    let dir = directory(name);
    let positions: Vec<Vector<T, D>> =
        (0..n).map(|k| Vector::from_fn(|c, _| T::of(k as f64 / 7.0 + c as f64))).collect();
    let velocity: Vec<Vector<T, D>> = (0..n).map(|k| Vector::from_fn(|c, _| awkward(k + c))).collect();
    let stress: Vec<Tensor<T, D>> =
        (0..n).map(|k| Tensor::from_fn(|r, c| T::of((9 * k + 3 * r + c) as f64))).collect();
    let pressure: Vec<T> = (0..n).map(awkward).collect();
    let kind: Vec<u32> = (0..n).map(|k| u32::MAX - k as u32).collect();
    let cloud = PointCloud::new(&positions)
        .scalar("pressure", &pressure)
        .vector("velocity", &velocity)
        .tensor("stress", &stress)
        .integer("kind", &kind);
    let mut writer = FieldWriter::new(&dir, "fluid", options).unwrap();
    let frame = Frame::read(&writer.write(0.125, &cloud).unwrap());

    let (set, cells) = match options.format {
        FieldFormat::Vtp => ("PolyData", "Verts"),
        _ => ("UnstructuredGrid", "Cells"),
    };
    for part in [
        format!("<VTKFile type=\"{set}\""),
        format!("  <{set}>\n"),
        format!("NumberOfPoints=\"{n}\" NumberOf{cells}=\"{n}\""),
        format!("      <{cells}>\n"),
        format!("      </{cells}>\n"),
        format!("  </{set}>\n"),
    ] {
        assert_eq!(frame.xml.matches(&part).count(), 1, "{part} in {}", frame.xml);
    }
    let padded = |v: &Vector<T, D>| (0..3).map(|c| if c < D { v[c] } else { T::zero() }).collect::<Vec<T>>();
    let tensor = |t: &Tensor<T, D>| {
        let at = |r, c| if r < D && c < D { t[(r, c)] } else { T::zero() };
        (0..9).map(|k| at(k / 3, k % 3)).collect::<Vec<T>>()
    };
    let single = options.single_precision || size_of::<T>() == 4;
    let expect = |field: &str, components: usize, values: Vec<T>| {
        let array = frame.array(field);
        assert_eq!(array.components, components);
        if single {
            let bits = |x: &f32| x.to_bits();
            let expected: Vec<u32> = values.iter().map(|x| bits(&(x.to_double() as f32))).collect();
            assert_eq!(array.singles().iter().map(bits).collect::<Vec<_>>(), expected, "{field}");
        } else {
            let bits = |x: &f64| x.to_bits();
            let expected: Vec<u64> = values.iter().map(|x| bits(&x.to_double())).collect();
            assert_eq!(array.doubles().iter().map(bits).collect::<Vec<_>>(), expected, "{field}");
        }
    };
    expect("Points", 3, positions.iter().flat_map(padded).collect());
    expect("pressure", 1, pressure.clone());
    expect("velocity", 3, velocity.iter().flat_map(padded).collect());
    expect("stress", 9, stress.iter().flat_map(tensor).collect());
    let kinds = frame.array("kind");
    assert_eq!(kinds.kind, "UInt32");
    assert!(kinds.bytes.as_chunks().0.iter().map(|b| u32::from_le_bytes(*b)).eq(kind));

    let wide = |array: Array| -> Vec<i64> {
        assert_eq!(array.kind, "Int64");
        array.bytes.as_chunks().0.iter().map(|b| i64::from_le_bytes(*b)).collect()
    };
    assert!(wide(frame.array("connectivity")).into_iter().eq(0..n as i64));
    assert!(wide(frame.array("offsets")).into_iter().eq(1..=n as i64));
    if options.format == FieldFormat::Vtu {
        assert_eq!(frame.array("types").bytes, vec![1u8; n]);
    } else {
        assert!(!frame.xml.contains("Name=\"types\""), "all cells of polygonal data are vertices");
    }
}

#[test]
fn polygonal_data_has_the_same_arrays() {
    let vtp = |compress, single_precision| FieldOptions {
        format: FieldFormat::Vtp,
        ..options(compress, single_precision)
    };
    round_trip::<f64, 2>("vtp-f64-2", 1000, vtp(true, false));
    round_trip::<f64, 3>("vtp-f64-3-single-raw", 1000, vtp(false, true));
    round_trip::<f32, 3>("vtp-f32-3", 1000, vtp(true, false));
    round_trip::<f64, 2>("vtp-none", 0, vtp(true, false));
}

/// A run in the directory of an earlier one with another form left the list of that one, which readers then opened for the new one.
#[test]
fn the_list_of_another_form_does_not_stay() {
    let dir = directory("forms");
    let at = [Vector::<f64, 2>::new(0.0, 1.0)];
    let write = |name: &str, format: FieldFormat| {
        let options = FieldOptions { format, ..FieldOptions::default() };
        FieldWriter::new(&dir, name, options).unwrap().write(0.0, &PointCloud::new(&at)).unwrap();
    };
    let lists = || -> Vec<String> {
        let is_list = |file: &String| !file.contains("_0");
        listing(&dir).into_iter().filter(is_list).collect()
    };
    write("gate", FieldFormat::Vtu);
    for (format, list) in [
        (FieldFormat::Vtu, "fluid.pvd"),
        (FieldFormat::VtkHdf, "fluid.vtkhdf.series"),
        (FieldFormat::Vtp, "fluid.pvd"),
        (FieldFormat::VtkHdf, "fluid.vtkhdf.series"),
        (FieldFormat::Vtu, "fluid.pvd"),
    ] {
        write("fluid", format);
        // Those of other series are left.
        assert_eq!(lists(), [list, "gate.pvd"]);
    }
    assert!(std::fs::read_to_string(dir.join("fluid.pvd")).unwrap().contains("fluid_00000.vtu"));
}

#[test]
fn doubles_in_two_dimensions_compressed() {
    round_trip::<f64, 2>("f64-2-zlib", 1000, options(true, false));
}

#[test]
fn doubles_in_three_dimensions_raw() {
    round_trip::<f64, 3>("f64-3-raw", 1000, options(false, false));
}

#[test]
fn doubles_rounded_to_single_precision() {
    round_trip::<f64, 3>("f64-3-single", 1000, options(true, true));
    round_trip::<f64, 2>("f64-2-single-raw", 1000, options(false, true));
}

#[test]
fn singles_stay_singles() {
    round_trip::<f32, 2>("f32-2-zlib", 1000, options(true, false));
    round_trip::<f32, 3>("f32-3-raw", 1000, options(false, true));
}

/// The length of the last block is written as 0 when it is full.
#[test]
fn arrays_that_end_at_a_block_and_next_to_it() {
    for n in [0, 1, 32_767, 32_768, 32_769, 65_536] {
        let options = options(true, false);
        round_trip::<f64, 2>(&format!("blocks-{n}"), n, options);
    }
}

/// The cells are kept from frame to frame: their number may change, the other arrays always do.
#[test]
fn frames_with_growing_and_shrinking_numbers_of_particles() {
    let dir = directory("numbers");
    let options = options(true, false);
    let mut writer = FieldWriter::new(&dir, "fluid", options).unwrap();
    for (frame, n) in [5usize, 5, 8, 8, 3, 0, 3].into_iter().enumerate() {
        let at: Vec<Vector<f64, 2>> = (0..n).map(|k| Vector::<f64, 2>::new(k as f64, frame as f64)).collect();
        let values: Vec<f64> = (0..n).map(|k| (10 * frame + k) as f64).collect();
        let cloud = PointCloud::new(&at).scalar("value", &values);
        let read = Frame::read(&writer.write(frame as f64, &cloud).unwrap());
        assert_eq!(read.array("value").doubles(), values);
        assert_eq!(read.array("Points").doubles().len(), 3 * n);
        assert_eq!(read.array("types").bytes, vec![1; n]);
        assert_eq!(read.array("offsets").bytes.len(), 8 * n);
        let connectivity = read.array("connectivity").bytes;
        assert!(connectivity.as_chunks().0.iter().map(|b| i64::from_le_bytes(*b)).eq(0..n as i64));
    }
}

#[test]
fn only_chosen_particles_are_written() {
    let at: Vec<Vector<f64, 2>> = (0..5).map(|k| Vector::<f64, 2>::new(f64::from(k), 0.5)).collect();
    let (values, id) = ([10.0, 11.0, 12.0, 13.0, 14.0], [5, 6, 7, 8, 9]);
    let cloud = PointCloud::new(&at).scalar("value", &values).integer("id", &id);
    let mut writer = FieldWriter::new(directory("chosen"), "fluid", options(true, false)).unwrap();
    let frame = Frame::read(&writer.write(0.0, &cloud.only(Some(&[4, 1]))).unwrap());
    assert!(frame.xml.contains("NumberOfPoints=\"2\" NumberOfCells=\"2\""));
    assert_eq!(frame.array("Points").doubles(), [4.0, 0.5, 0.0, 1.0, 0.5, 0.0]);
    assert_eq!(frame.array("value").doubles(), [14.0, 11.0]);
    assert_eq!(frame.array("id").bytes, [9, 0, 0, 0, 6, 0, 0, 0]);
    let error = writer.write(0.0, &PointCloud::new(&at).only(Some(&[5]))).unwrap_err();
    assert!(matches!(error, OutputError::NoParticle { particle: 5, particles: 5 }), "{error}");
}

#[test]
fn the_same_particles_give_the_same_bytes() {
    let dir = directory("same");
    let at = [Vector::<f64, 3>::new(1.0, 2.0, 3.0); 10];
    for compress in [true, false] {
        let options = options(compress, false);
        let mut writer = FieldWriter::new(&dir, "fluid", options).unwrap();
        let mut write = || Frame::read(&writer.write(0.0, &PointCloud::new(&at)).unwrap()).appended;
        let first = write();
        assert!(first == write() && first == write());
    }
}

#[test]
fn the_collection_lists_every_frame_and_no_part_is_left() {
    let dir = directory("collection");
    let positions = [Vector::<f64, 2>::new(0.0, 1.0)];
    let mut writer = FieldWriter::new(&dir, "fluid", FieldOptions::default()).unwrap();
    let times = [0.0, 0.1, 1.0 / 3.0, 1e-7, 12.5];
    for (k, time) in times.iter().enumerate() {
        let path = writer.write(*time, &PointCloud::new(&positions)).unwrap();
        assert_eq!(path, dir.join(format!("fluid_{k:05}.vtu")));
        // Complete after every frame: a running job can be opened.
        let collection = std::fs::read_to_string(writer.collection()).unwrap();
        let entries: Vec<&str> = collection.lines().filter(|line| line.contains("<DataSet")).collect();
        assert_eq!(entries.len(), k + 1);
        for (j, entry) in entries.iter().enumerate() {
            assert_eq!(attribute(entry, "timestep").parse::<f64>().unwrap(), times[j]);
            assert_eq!(attribute(entry, "file"), format!("fluid_{j:05}.vtu"));
        }
        assert!(collection.ends_with("</VTKFile>\n"));
    }
    let mut expected: Vec<String> = (0..5).map(|k| format!("fluid_{k:05}.vtu")).collect();
    expected.insert(0, "fluid.pvd".to_owned());
    assert_eq!(listing(&dir), expected);
}

#[test]
fn names_are_escaped() {
    let dir = directory("names");
    let positions = [Vector::<f64, 2>::new(0.0, 1.0)];
    let cloud = PointCloud::new(&positions).scalar("p < \"q\" & r [Pa]", &[2.5]);
    let options = options(false, false);
    let frame = Frame::read(&FieldWriter::new(&dir, "a&b", options).unwrap().write(0.0, &cloud).unwrap());
    assert_eq!(frame.array("p &lt; &quot;q&quot; &amp; r [Pa]").doubles(), [2.5]);
    assert!(std::fs::read_to_string(dir.join("a&b.pvd")).unwrap().contains("file=\"a&amp;b_00000.vtu\""));
}

#[test]
fn wrong_fields_are_refused_and_write_nothing() {
    let dir = directory("wrong");
    let positions = [Vector::<f64, 2>::new(0.0, 1.0); 3];
    let mut writer = FieldWriter::new(&dir, "fluid", FieldOptions::default()).unwrap();
    let error = writer.write(0.0, &PointCloud::new(&positions).scalar("pressure", &[1.0])).unwrap_err();
    assert!(matches!(error, OutputError::FieldLength { expected: 3, found: 1, .. }), "{error}");
    assert!(error.to_string().contains("'pressure' has 1 values for 3 particles"), "{error}");
    let twice = PointCloud::new(&positions).scalar("p", &[1.0; 3]).scalar("p", &[2.0; 3]);
    let error = writer.write(0.0, &twice).unwrap_err();
    assert!(matches!(error, OutputError::Name { .. }), "{error}");
    assert_eq!(listing(&dir), Vec::<String>::new());
    assert!(FieldWriter::new(&dir, "a/b", FieldOptions::default()).is_err());
}
