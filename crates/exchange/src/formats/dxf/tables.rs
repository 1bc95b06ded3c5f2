//! What every DXF file of this version must have: tables, blocks and the root dictionary.

use super::{APPLICATION, Tags};
use crate::drawing::Layer;

/// Handles are the names of objects, in hexadecimal and counted up.
#[derive(Default)]
pub(super) struct Handles {
    last: u32,
}

impl Handles {
    pub(super) fn next(&mut self) -> String {
        self.last = self.last.saturating_add(1);
        format!("{:X}", self.last)
    }
}

const BLOCKS: [&str; 2] = ["*Model_Space", "*Paper_Space"];

/// Writes the sections of tables and blocks; gives the handle of the model space, the owner of entities.
pub(super) fn write(tags: &mut Tags, handles: &mut Handles) -> String {
    tags.section("TABLES");
    table(tags, handles, "VPORT", &[], |_, _| {});
    let line_types = ["ByBlock", "ByLayer", "CONTINUOUS", "DASHED", "DASHDOT"];
    let kind = "AcDbLinetypeTableRecord";
    table(
        tags,
        handles,
        "LTYPE",
        &line_types.map(|n| (kind, n)),
        |tags, name| {
            // Lengths of strokes and gaps in millimetres; a stroke of no length is a dot.
            let (shown, dashes): (&str, &[i32]) = match name {
                "DASHED" => ("__ __", &[6, -3]),
                "DASHDOT" => ("__ . __", &[6, -3, 0, -3]),
                _ => ("", &[]),
            };
            let length: i32 = dashes.iter().map(|dash| dash.abs()).sum();
            tags.tag(3, shown)
                .tag(72, 65)
                .tag(73, dashes.len())
                .tag(40, length);
            for dash in dashes {
                tags.tag(49, dash).tag(74, 0);
            }
        },
    );
    let mut layers = vec![("AcDbLayerTableRecord", "0")];
    layers.extend(Layer::ALL.map(|layer| ("AcDbLayerTableRecord", layer.name())));
    table(tags, handles, "LAYER", &layers, |tags, name| {
        let (colour, line) = look(Layer::named(name));
        tags.tag(62, colour).tag(6, line);
    });
    let styles = [("AcDbTextStyleTableRecord", "Standard")];
    table(tags, handles, "STYLE", &styles, |tags, _| {
        tags.tag(40, 0).tag(41, 1).tag(50, 0).tag(71, 0);
        tags.tag(42, 2.5).tag(3, "txt").tag(4, "");
    });
    table(tags, handles, "VIEW", &[], |_, _| {});
    table(tags, handles, "UCS", &[], |_, _| {});
    let applications = ["ACAD", APPLICATION].map(|name| ("AcDbRegAppTableRecord", name));
    table(tags, handles, "APPID", &applications, |_, _| {});
    let dimensions = [("AcDbDimStyleTableRecord", "Standard")];
    table(tags, handles, "DIMSTYLE", &dimensions, |_, _| {});
    let records = BLOCKS.map(|name| ("AcDbBlockTableRecord", name));
    let owners = table(tags, handles, "BLOCK_RECORD", &records, |tags, _| {
        tags.tag(340, 0);
    });
    tags.end_section();

    tags.section("BLOCKS");
    for (name, owner) in BLOCKS.iter().zip(&owners) {
        for kind in ["BLOCK", "ENDBLK"] {
            tags.tag(0, kind).tag(5, handles.next()).tag(330, owner);
            tags.tag(100, "AcDbEntity");
            if *name != BLOCKS[0] {
                tags.tag(67, 1);
            }
            tags.tag(8, 0);
            if kind == "ENDBLK" {
                tags.tag(100, "AcDbBlockEnd");
                continue;
            }
            tags.tag(100, "AcDbBlockBegin").tag(2, name).tag(70, 0);
            tags.tag(10, 0)
                .tag(20, 0)
                .tag(30, 0)
                .tag(3, name)
                .tag(1, "");
        }
    }
    tags.end_section();
    owners.into_iter().next().unwrap_or_default()
}

/// Writes the root dictionary with the dictionary of groups that readers look for.
pub(super) fn write_objects(tags: &mut Tags, handles: &mut Handles) {
    let (root, groups) = (handles.next(), handles.next());
    tags.section("OBJECTS");
    tags.tag(0, "DICTIONARY").tag(5, &root).tag(330, 0);
    tags.tag(100, "AcDbDictionary").tag(281, 1);
    tags.tag(3, "ACAD_GROUP").tag(350, &groups);
    tags.tag(0, "DICTIONARY").tag(5, &groups).tag(330, &root);
    tags.tag(100, "AcDbDictionary").tag(281, 1);
    tags.end_section();
}

/// A table of records, each its class and name; gives the handles of the records.
fn table(
    tags: &mut Tags,
    handles: &mut Handles,
    name: &str,
    records: &[(&str, &str)],
    rest: impl Fn(&mut Tags, &str),
) -> Vec<String> {
    let owner = handles.next();
    tags.tag(0, "TABLE").tag(2, name).tag(5, &owner).tag(330, 0);
    tags.tag(100, "AcDbSymbolTable").tag(70, records.len());
    if name == "DIMSTYLE" {
        tags.tag(100, "AcDbDimStyleTable").tag(71, records.len());
    }
    let mut given = Vec::with_capacity(records.len());
    for (class, record) in records {
        let handle = handles.next();
        // The one kind of record whose handle has a code of its own.
        let code = if name == "DIMSTYLE" { 105 } else { 5 };
        tags.tag(0, name).tag(code, &handle).tag(330, &owner);
        tags.tag(100, "AcDbSymbolTableRecord").tag(100, class);
        tags.tag(2, record);
        if name != "BLOCK_RECORD" {
            tags.tag(70, 0);
        }
        rest(tags, record);
        given.push(handle);
    }
    tags.tag(0, "ENDTAB");
    given
}

/// The colour number and the line type of a layer.
fn look(layer: Option<Layer>) -> (u8, &'static str) {
    match layer {
        None | Some(Layer::Outline) => (7, "CONTINUOUS"),
        Some(Layer::Rulings) => (8, "CONTINUOUS"),
        Some(Layer::BendUp) => (5, "DASHED"),
        Some(Layer::BendDown) => (1, "DASHDOT"),
        Some(Layer::Regression) => (6, "CONTINUOUS"),
        Some(Layer::Marks) => (3, "CONTINUOUS"),
    }
}
