//! DXF, as text or binary: lines, arcs, circles, ellipses, polylines with bulges, splines, and blocks that are inserted.
//!
//! Group codes are those of Autodesk's DXF reference. The unit is `$INSUNITS` of the header; older files have none, nor
//! have files that say zero. Entities of the paper space, invisible ones, and those on layers that are frozen or off are passed
//! over; those of blocks on the layer `0` are on the layer of what inserts the block. Names of layers and blocks are the same
//! in capitals.

pub(super) mod binary;
mod entities;
mod groups;

use super::error::{ReadError, ReadResult, at, at_line};
use super::imported::{Imported, PassedOver};
use super::{Drafts, FileKind, LengthUnit, check_unit};
use entities::insert_map;
use groups::{Entity, Group, groups};
use std::collections::HashMap;
use torse_algebra::Rational;
use torse_algebra::rational::ratio;
use torse_geometry::AffineMap;

/// How deep blocks are inserted into blocks.
const MAX_DEPTH: usize = 16;
/// The most entities, those of inserted blocks counted each time.
const MAX_ENTITIES: usize = 500_000;

pub(super) fn read(text: &str, given: Option<&LengthUnit>) -> ReadResult<Imported> {
    let all = groups(text)?;
    if all
        .iter()
        .rev()
        .find(|group| group.code == 0)
        .is_none_or(|last| last.value != "EOF")
    {
        let line = text.lines().count().max(1);
        return Err(at_line(
            line,
            "the file ends in the middle: `EOF` is missing",
        ));
    }
    let file = File::new(&all);
    let unit = check_unit(file.unit()?, given)?;
    let mut reader = Reader {
        blocks: &file.blocks,
        hidden: &file.hidden,
        drafts: Drafts::new(&unit),
        passed: PassedOver::default(),
        seen: 0,
    };
    let map = AffineMap::stretch(unit.unit().millimetres());
    reader.entities(&file.entities, &map, &mut Vec::new())?;
    reader.drafts.finish(FileKind::Dxf, None, reader.passed)
}

/// The sections of a file.
#[derive(Default)]
struct File<'t, 'g> {
    header: &'g [Group<'t>],
    blocks: HashMap<NameKey, Block<'t, 'g>>,
    hidden: HashMap<NameKey, HiddenLayer>,
    entities: Vec<Entity<'t, 'g>>,
}

/// A name of a layer or a block without regard to case.
#[derive(Clone, PartialEq, Eq, Hash)]
struct NameKey(String);

impl NameKey {
    fn new(name: &str) -> Self {
        Self(name.to_lowercase())
    }
}

/// Why a layer is not shown.
#[derive(Clone, Copy, PartialEq)]
enum HiddenLayer {
    /// What is on it is not shown, and nothing of a block that is inserted on it.
    Frozen,
    /// What is on it is not shown.
    Off,
}

impl HiddenLayer {
    /// Returns why the layer of an entry of the table of layers is not shown; nothing where it is shown.
    fn of(entry: &Entity<'_, '_>) -> Option<Self> {
        let whole = |code| entry.text(code).and_then(|value| value.parse::<i64>().ok());
        if whole(70).is_some_and(|flags| flags & 1 == 1) {
            Some(Self::Frozen)
        } else {
            // The colour of a layer that is off is negative.
            whole(62).filter(|colour| *colour < 0).map(|_| Self::Off)
        }
    }

    /// Returns what is passed over.
    fn words(self, layer: &str) -> String {
        let state = match self {
            Self::Frozen => "frozen",
            Self::Off => "off",
        };
        format!("entity on the layer `{layer}`, which is {state}")
    }
}

/// A block that is being inserted, and the layer that its entities on the layer `0` take.
struct Inserted<'t> {
    block: NameKey,
    layer: &'t str,
}

/// A block: its base point is that of its first entity, the `BLOCK` itself.
#[derive(Default)]
struct Block<'t, 'g> {
    head: Option<Entity<'t, 'g>>,
    entities: Vec<Entity<'t, 'g>>,
}

impl<'t, 'g> File<'t, 'g> {
    fn new(all: &'g [Group<'t>]) -> Self {
        let mut file = Self::default();
        let starts: Vec<usize> = (0..all.len()).filter(|k| all[*k].code == 0).collect();
        let ends = starts.iter().skip(1).copied().chain([all.len()]);
        let (mut section, mut block) = ("", None);
        for (start, end) in starts.iter().zip(ends) {
            let entity = Entity {
                kind: all[*start].value,
                line: all[*start].line,
                groups: &all[start + 1..end],
            };
            match (section, entity.kind) {
                (_, "SECTION") => {
                    section = entity.text(2).unwrap_or_default();
                    if section == "HEADER" {
                        file.header = entity.groups;
                    }
                }
                (_, "ENDSEC" | "EOF") => section = "",
                ("ENTITIES", _) => file.entities.push(entity),
                ("TABLES", "LAYER") => {
                    if let (Some(name), Some(state)) = (entity.text(2), HiddenLayer::of(&entity)) {
                        file.hidden.insert(NameKey::new(name), state);
                    }
                }
                ("BLOCKS", "BLOCK") => {
                    block = entity.text(2).map(NameKey::new);
                    if let Some(name) = &block {
                        file.blocks.entry(name.clone()).or_default().head = Some(entity);
                    }
                }
                ("BLOCKS", "ENDBLK") => block = None,
                ("BLOCKS", _) => {
                    if let Some(block) = block.as_ref().and_then(|name| file.blocks.get_mut(name)) {
                        block.entities.push(entity);
                    }
                }
                _ => {}
            }
        }
        file
    }

    /// The unit that the header states.
    fn unit(&self) -> ReadResult<Option<LengthUnit>> {
        let mut after = self
            .header
            .iter()
            .skip_while(|group| group.value != "$INSUNITS");
        let Some(group) = after.find(|group| group.code == 70) else {
            return Ok(None);
        };
        let number = group.value.parse::<i64>();
        let place = super::FilePlace::entity(group.line, "$INSUNITS");
        unit_of(number.map_err(|_| at(&place, "no whole number"))?)
            .map_err(|reason| at(&place, reason))
    }
}

/// The unit of length that `$INSUNITS` numbers; none for zero.
pub(crate) fn unit_of(number: i64) -> Result<Option<LengthUnit>, String> {
    let named = |name: &str| Ok(LengthUnit::named(name));
    let own = |name: &str, n: i64, d: i64| Ok(ratio(n, d).and_then(|mm| LengthUnit::new(name, mm)));
    match number {
        0 => Ok(None),
        1 => named("in"),
        2 => named("ft"),
        3 => named("mi"),
        4 => named("mm"),
        5 => named("cm"),
        6 => named("m"),
        7 => named("km"),
        8 => own("microinch", 127, 5_000_000),
        9 => named("mil"),
        10 => named("yd"),
        11 => own("angstrom", 1, 10_000_000),
        12 => own("nm", 1, 1_000_000),
        13 => named("um"),
        14 => named("dm"),
        15 => own("dam", 10_000, 1),
        16 => own("hm", 100_000, 1),
        21 => own("US survey foot", 1_200_000, 3937),
        other => Err(format!("{other} is no unit of length that is read")),
    }
}

struct Reader<'t, 'g, 'f> {
    blocks: &'f HashMap<NameKey, Block<'t, 'g>>,
    hidden: &'f HashMap<NameKey, HiddenLayer>,
    drafts: Drafts,
    passed: PassedOver,
    seen: usize,
}

impl<'t, 'g> Reader<'t, 'g, '_> {
    fn entities(
        &mut self,
        list: &[Entity<'t, 'g>],
        map: &AffineMap<Rational>,
        inside: &mut Vec<Inserted<'t>>,
    ) -> ReadResult<()> {
        let mut index = 0;
        while let Some(entity) = list.get(index) {
            index += 1;
            self.seen += 1;
            if self.seen > MAX_ENTITIES {
                return Err(ReadError::TooMuch {
                    place: entity.place(),
                    what: "entities",
                    most: MAX_ENTITIES,
                });
            }
            // The vertices of a polyline follow it.
            let vertices = list.get(index..).unwrap_or_default();
            let count = match entity.kind {
                "POLYLINE" => vertices
                    .iter()
                    .take_while(|next| next.kind == "VERTEX")
                    .count(),
                _ => 0,
            };
            let vertices = vertices.get(..count).unwrap_or_default();
            index += count;
            if entity.text(67) == Some("1") {
                self.passed.add("entity of the paper space");
                continue;
            }
            if entity.whole(60, 0)? == 1 {
                self.passed.add("hidden entity");
                continue;
            }
            let layer = match (entity.layer(), inside.last()) {
                ("0", Some(insert)) => insert.layer,
                (own, _) => own,
            };
            let hidden = self.hidden.get(&NameKey::new(layer)).copied();
            let inserts = entity.kind == "INSERT";
            // Of a block that is inserted on a layer that is off, what has layers of its own is shown.
            if let Some(state) = hidden.filter(|s| *s == HiddenLayer::Frozen || !inserts) {
                self.passed.add(&state.words(layer));
                continue;
            }
            if inserts {
                self.insert(entity, layer, map, inside)?;
                continue;
            }
            match entities::curve(entity, vertices)? {
                Some(shape) => {
                    let name = if layer == "0" {
                        entity.kind.to_lowercase()
                    } else {
                        layer.to_owned()
                    };
                    let shape = shape.mapped(map);
                    let index = self.drafts.curve(&name, entity.place(), shape)?;
                    self.drafts.set_layer(index, layer);
                }
                None if matches!(entity.kind, "SEQEND" | "VERTEX" | "VIEWPORT" | "ATTRIB") => {}
                None => self.passed.add_at(entity.kind, &entity.place()),
            }
        }
        Ok(())
    }

    fn insert(
        &mut self,
        entity: &Entity<'t, 'g>,
        layer: &'t str,
        map: &AffineMap<Rational>,
        inside: &mut Vec<Inserted<'t>>,
    ) -> ReadResult<()> {
        let place = entity.place();
        let name = entity
            .text(2)
            .ok_or_else(|| at(&place, "an INSERT without its block (group 2)"))?;
        let blocks = self.blocks;
        let key = NameKey::new(name);
        let Some(block) = blocks.get(&key) else {
            let name: String = name.chars().take(60).collect();
            return Err(at(&place, format!("there is no block `{name}`")));
        };
        if inside.iter().any(|insert| insert.block == key) {
            let name: String = name.chars().take(60).collect();
            return Err(at(
                &place,
                format!("block `{name}` is inserted into itself"),
            ));
        }
        if inside.len() >= MAX_DEPTH {
            return Err(ReadError::TooMuch {
                place,
                what: "blocks inside each other",
                most: MAX_DEPTH,
            });
        }
        let base = match &block.head {
            Some(head) if head.text(10).is_some() => head.point(10)?,
            _ => std::array::from_fn(|_| Rational::default()),
        };
        let count = |code| -> ReadResult<i64> {
            let count = entity.whole(code, 1)?.max(1);
            if count > 100_000 {
                return Err(at(&place, format!("{count} copies in a row")));
            }
            Ok(count)
        };
        let (columns, rows) = (count(70)?, count(71)?);
        inside.push(Inserted { block: key, layer });
        for row in 0..rows {
            for column in 0..columns {
                self.seen += 1;
                if self.seen > MAX_ENTITIES {
                    return Err(ReadError::TooMuch {
                        place,
                        what: "entities",
                        most: MAX_ENTITIES,
                    });
                }
                let local = insert_map(entity, &base, [column, row])?;
                self.entities(&block.entities, &map.after(&local), inside)?;
            }
        }
        inside.pop();
        Ok(())
    }
}
