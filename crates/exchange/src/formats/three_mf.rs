//! 3MF core specification 1.3: a mesh in XML within a ZIP archive.

use super::check_not_empty;
use super::zip::archive;
use crate::error::Result;
use crate::mesh::Mesh;
use std::fmt::Write;

/// The mesh as 3MF in millimetres, in double precision. A [watertight](Mesh::is_watertight) mesh becomes an
/// object of type `model`, which a printer can build; another one is of type `surface`.
///
/// # Errors
/// [`ExchangeError::Empty`](crate::ExchangeError::Empty),
/// [`ExchangeError::TooMany`](crate::ExchangeError::TooMany) for a file of 4 GiB.
///
/// ```
/// use torse_exchange::{Mesh, three_mf};
/// let file = three_mf(&Mesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]])?)?;
/// assert!(file.starts_with(b"PK\x03\x04"));
/// # Ok::<(), torse_exchange::ExchangeError>(())
/// ```
pub fn three_mf(mesh: &Mesh) -> Result<Vec<u8>> {
    check_not_empty(mesh)?;
    let kind = if mesh.is_watertight() {
        "model"
    } else {
        "surface"
    };
    let (vertices, triangles) = mesh.merged();
    let mut model = format!(
        concat!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
            "<model unit=\"millimeter\" xml:lang=\"en-US\" ",
            "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n",
            "<metadata name=\"Application\">torse</metadata>\n",
            "<resources><object id=\"1\" type=\"{}\"><mesh>\n<vertices>\n"
        ),
        kind
    );
    for point in vertices {
        let [x, y, z] = point.map(|x| x + 0.0);
        let _ = writeln!(model, "<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>");
    }
    model.push_str("</vertices>\n<triangles>\n");
    for [a, b, c] in triangles {
        let _ = writeln!(model, "<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\"/>");
    }
    model.push_str("</triangles>\n</mesh></object></resources>\n");
    model.push_str("<build><item objectid=\"1\"/></build>\n</model>\n");
    let parts: [(&str, &[u8]); 3] = [
        ("[Content_Types].xml", CONTENT_TYPES.as_bytes()),
        ("_rels/.rels", RELATIONSHIPS.as_bytes()),
        ("3D/3dmodel.model", model.as_bytes()),
    ];
    archive(&parts)
}

const CONTENT_TYPES: &str = concat!(
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">",
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>",
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>",
    "</Types>\n"
);

const RELATIONSHIPS: &str = concat!(
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">",
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" ",
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>",
    "</Relationships>\n"
);
