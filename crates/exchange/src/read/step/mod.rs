//! STEP (ISO 10303-21 with the shapes of AP203, AP214 and AP242).
//!
//! Read are curves (lines, conics, polylines, B-splines rational or not, trimmed and composite ones), surfaces (analytic,
//! extruded, revolved, B-splines) and faces with their edges. Parts are where assemblies place them. Numbers of points,
//! knots and weights are the decimals of the file; directions are f64.

mod curves;
mod part21;
mod structure;
mod surfaces;
mod values;

use super::error::{ReadError, ReadResult, at};
use super::imported::{Imported, PassedOver};
use super::{Drafts, FaceBorder, FileKind, ImportedFace, LengthUnit, UnitSource, check_unit};
use curves::Curves;
use part21::{Data, Instance, Value, parse};
use std::collections::{HashMap, HashSet};
use structure::{Context, Placed, motion, stretch, too_deep};
use torse_algebra::Rational;
use torse_geometry::{AffineMap, Coordinate};
use values::{Resolver, label, list, truth};

/// How deep parts are placed in parts, and items in items.
const MAX_DEPTH: usize = 32;
/// The most placements of parts.
const MAX_PLACEMENTS: usize = 100_000;

pub(super) fn read(text: &str, given: Option<&LengthUnit>) -> ReadResult<Imported> {
    let data = parse(text)?;
    let resolver = Resolver::new(&data);
    let mut contexts = HashMap::new();
    let mut stated: Option<LengthUnit> = None;
    let mut uncertainty: Option<f64> = None;
    let mut representations: Vec<&Instance<'_>> = Vec::new();
    for instance in data.all() {
        let Some(values) = structure::representation(instance) else {
            continue;
        };
        let context = resolver.context(instance, values.get(2))?;
        stated = stated.or(context.unit.clone());
        if let (Some(own), Some(unit)) = (context.uncertainty, &context.unit) {
            let own = own * unit.millimetres().approximate();
            uncertainty = Some(uncertainty.map_or(own, |least| least.max(own)));
        }
        contexts.insert(instance.id, context);
        representations.push(instance);
    }
    let unit = check_unit(stated, given)?;
    let mut reader = Reader {
        data: &data,
        resolver: &resolver,
        contexts,
        placements: HashMap::new(),
        drafts: Drafts::new(&unit),
        passed: PassedOver::default(),
        unit,
        placed: 0,
        edges: HashMap::new(),
    };
    let placements = resolver.placements()?;
    let children: HashSet<u64> = placements.iter().map(|placed| placed.child).collect();
    for placed in placements {
        reader
            .placements
            .entry(placed.parent)
            .or_default()
            .push(placed);
    }
    let identity = AffineMap::stretch(&Rational::from(1));
    let mapped: HashSet<u64> = data
        .instances("REPRESENTATION_MAP")
        .filter_map(|map| match map.part("REPRESENTATION_MAP")?.get(1)? {
            Value::Reference(id) => Some(*id),
            _ => None,
        })
        .collect();
    for root in &representations {
        if !children.contains(&root.id) && !mapped.contains(&root.id) {
            reader.representation(root, &identity, 0)?;
        }
    }
    reader
        .drafts
        .finish(FileKind::Step, uncertainty, reader.passed)
}

struct Reader<'t, 'd> {
    data: &'d Data<'t>,
    resolver: &'d Resolver<'t, 'd>,
    contexts: HashMap<u64, Context>,
    /// What is placed below a representation.
    placements: HashMap<u64, Vec<Placed>>,
    drafts: Drafts,
    passed: PassedOver,
    unit: UnitSource,
    placed: usize,
    /// The curves of edges, by their number, of the placement at hand.
    edges: HashMap<u64, Option<usize>>,
}

/// What holds for the items of a placed representation.
struct Setting<'t, 'd> {
    curves: Curves<'t, 'd, 'd>,
    /// From the numbers of the file to millimetres in place.
    map: AffineMap<Rational>,
    factor: f64,
}

impl<'t, 'd> Reader<'t, 'd> {
    fn millimetres(&self, representation: u64) -> Rational {
        let context = self.contexts.get(&representation);
        let unit = context.and_then(|context| context.unit.clone());
        unit.unwrap_or_else(|| self.unit.unit())
            .millimetres()
            .clone()
    }

    /// Reads a representation and what is placed below it; `place` is in millimetres.
    fn representation(
        &mut self,
        instance: &'d Instance<'t>,
        place: &AffineMap<Rational>,
        depth: usize,
    ) -> ReadResult<()> {
        self.placed += 1;
        if depth > MAX_DEPTH {
            return Err(too_deep(instance, MAX_DEPTH));
        }
        if self.placed > MAX_PLACEMENTS {
            return Err(ReadError::TooMuch {
                place: instance.place(),
                what: "placements of parts",
                most: MAX_PLACEMENTS,
            });
        }
        let own = self.millimetres(instance.id);
        let map = place.after(&AffineMap::stretch(&own));
        let setting = Setting {
            curves: Curves {
                resolver: self.resolver,
                angle: self
                    .contexts
                    .get(&instance.id)
                    .map_or(1.0, |context| context.angle),
            },
            factor: stretch(&map),
            map,
        };
        let outer = std::mem::take(&mut self.edges);
        for item in self.resolver.items(instance)? {
            let found = self.data.get(item);
            let item = found
                .ok_or_else(|| at(&instance.place(), format!("there is no instance #{item}")))?;
            if let Some(values) = item.part("MAPPED_ITEM") {
                self.mapped(instance, item, values, place, depth)?;
                continue;
            }
            self.item(item, &setting, 0)?;
        }
        self.edges = outer;
        let below = self.placements.remove(&instance.id).unwrap_or_default();
        for placed in &below {
            let Some(child) = self.data.get(placed.child) else {
                continue;
            };
            if !self.contexts.contains_key(&child.id) {
                continue;
            }
            let local = match &placed.axes {
                None => place.clone(),
                Some(axes) => place.after(&motion(axes, [&self.millimetres(child.id), &own])),
            };
            self.representation(child, &local, depth + 1)?;
        }
        self.placements.insert(instance.id, below);
        Ok(())
    }

    /// A representation that is placed as an item of another.
    fn mapped(
        &mut self,
        from: &Instance<'t>,
        item: &Instance<'t>,
        values: &[Value<'t>],
        place: &AffineMap<Rational>,
        depth: usize,
    ) -> ReadResult<()> {
        let source = self.resolver.instance(item, values.get(1))?;
        let map = self.resolver.part(source, "REPRESENTATION_MAP")?;
        let child = self.resolver.instance(source, map.get(1))?;
        if !self.contexts.contains_key(&child.id) {
            return Err(at(&child.place(), "a representation that is not read"));
        }
        let target = self.resolver.instance(item, values.get(2))?;
        if target.part("AXIS2_PLACEMENT_3D").is_none() {
            self.passed
                .add(&format!("part placed by {}", target.keyword()));
            return Ok(());
        }
        let axes = [
            self.resolver.axes(source, map.first())?,
            self.resolver.axes(item, values.get(2))?,
        ];
        let units = [&self.millimetres(child.id), &self.millimetres(from.id)];
        let local = place.after(&motion(&axes, units));
        self.representation(child, &local, depth + 1)
    }

    /// Reads a geometric or topological item and what it consists of.
    fn item(
        &mut self,
        item: &'d Instance<'t>,
        setting: &Setting<'t, 'd>,
        depth: usize,
    ) -> ReadResult<()> {
        if depth > MAX_DEPTH {
            return Err(too_deep(item, MAX_DEPTH));
        }
        let keyword = item.keyword();
        let values = item.parts.first().map_or(&[][..], |(_, values)| values);
        let resolver = self.resolver;
        match keyword {
            "MANIFOLD_SOLID_BREP" | "FACETED_BREP" => {
                self.item(resolver.instance(item, values.get(1))?, setting, depth + 1)
            }
            "BREP_WITH_VOIDS" => {
                self.item(resolver.instance(item, values.get(1))?, setting, depth + 1)?;
                self.items(item, values.get(2), setting, depth)
            }
            "ORIENTED_CLOSED_SHELL" | "ORIENTED_OPEN_SHELL" => {
                self.item(resolver.instance(item, values.get(2))?, setting, depth + 1)
            }
            "SHELL_BASED_SURFACE_MODEL"
            | "FACE_BASED_SURFACE_MODEL"
            | "OPEN_SHELL"
            | "CLOSED_SHELL"
            | "CONNECTED_FACE_SET"
            | "GEOMETRIC_CURVE_SET"
            | "GEOMETRIC_SET"
            | "EDGE_BASED_WIREFRAME_MODEL"
            | "CONNECTED_EDGE_SET"
            | "SHELL_BASED_WIREFRAME_MODEL"
            | "WIRE_SHELL" => self.items(item, values.get(1), setting, depth),
            "EDGE_LOOP" => self.loop_of(item, setting).map(|_| ()),
            "EDGE_CURVE" => self.edge(item, setting).map(|_| ()),
            "ADVANCED_FACE" | "FACE_SURFACE" => self.face(item, values, setting),
            "AXIS2_PLACEMENT_3D" | "CARTESIAN_POINT" | "DIRECTION" | "PLACEMENT" => Ok(()),
            _ => {
                if let Some(shape) = setting.curves.whole(item)? {
                    let name = self.name(item);
                    self.drafts
                        .curve(&name, item.place(), shape.mapped(&setting.map))?;
                } else if let Some(surface) = setting.curves.surface(item)? {
                    let name = self.name(item);
                    let face = ImportedFace {
                        name: String::new(),
                        place: item.place(),
                        surface: surface.moved(&setting.map, setting.factor),
                        loops: Vec::new(),
                        border: FaceBorder::OwnOfSurface,
                        forward: true,
                    };
                    self.drafts.face(&name, face);
                } else {
                    self.passed.add(keyword);
                }
                Ok(())
            }
        }
    }

    fn items(
        &mut self,
        item: &'d Instance<'t>,
        value: Option<&Value<'t>>,
        setting: &Setting<'t, 'd>,
        depth: usize,
    ) -> ReadResult<()> {
        for one in self.resolver.instances(item, value)? {
            self.item(one, setting, depth + 1)?;
        }
        Ok(())
    }

    /// The label, or the number.
    fn name(&self, item: &Instance<'t>) -> String {
        let own = item
            .parts
            .iter()
            .find_map(|(_, values)| label(values.first()));
        own.map_or_else(|| item.id.to_string(), str::to_owned)
    }

    fn face(
        &mut self,
        item: &'d Instance<'t>,
        values: &[Value<'t>],
        setting: &Setting<'t, 'd>,
    ) -> ReadResult<()> {
        let geometry = self.resolver.instance(item, values.get(2))?;
        let mut loops = Vec::new();
        let (mut outer, mut all_read) = (Vec::new(), true);
        for bound in self.resolver.instances(item, values.get(1))? {
            let values = bound.parts.first().map_or(&[][..], |(_, values)| values);
            if !matches!(bound.keyword(), "FACE_BOUND" | "FACE_OUTER_BOUND") {
                return Err(at(&bound.place(), "FACE_BOUND is wanted here"));
            }
            let edges = self.resolver.instance(bound, values.get(1))?;
            if edges.part("EDGE_LOOP").is_none() {
                self.passed.add(&format!("bound by {}", edges.keyword()));
                // A vertex bounds nothing: it is the apex of a cone, or lies within the face.
                all_read &= edges.part("VERTEX_LOOP").is_some();
                continue;
            }
            let (mut edges, whole) = self.loop_of(edges, setting)?;
            all_read &= whole;
            if bound.keyword() == "FACE_OUTER_BOUND" {
                outer.push(loops.len());
            }
            if !truth(values.get(2)) {
                edges.reverse();
                for (_, forward) in &mut edges {
                    *forward = !*forward;
                }
            }
            loops.push(edges);
        }
        let Some(surface) = setting.curves.surface(geometry)? else {
            self.passed.add(&format!("face on {}", geometry.keyword()));
            return Ok(());
        };
        let face = ImportedFace {
            name: String::new(),
            place: item.place(),
            surface: surface.moved(&setting.map, setting.factor),
            loops,
            border: match outer.as_slice() {
                _ if !all_read => FaceBorder::NotRead,
                [outer] => FaceBorder::Loop(*outer),
                _ => FaceBorder::Unstated,
            },
            forward: truth(values.get(3)),
        };
        let name = self.name(item);
        self.drafts.face(&name, face);
        Ok(())
    }

    /// The edges of a loop, and whether they are all: those whose curve is not read are left out, and counted.
    fn loop_of(
        &mut self,
        item: &'d Instance<'t>,
        setting: &Setting<'t, 'd>,
    ) -> ReadResult<(Vec<(usize, bool)>, bool)> {
        let values = self.resolver.part(item, "EDGE_LOOP")?;
        let (mut edges, mut whole) = (Vec::new(), true);
        for oriented in list(item, values.get(1))? {
            let oriented = self.resolver.instance(item, Some(oriented))?;
            let (edge, forward) = match oriented.part("ORIENTED_EDGE") {
                Some(values) => (
                    self.resolver.instance(oriented, values.get(3))?,
                    truth(values.get(4)),
                ),
                None => (oriented, true),
            };
            match self.edge(edge, setting)? {
                Some(index) => edges.push((index, forward)),
                None => whole = false,
            }
        }
        Ok((edges, whole))
    }

    fn edge(
        &mut self,
        edge: &'d Instance<'t>,
        setting: &Setting<'t, 'd>,
    ) -> ReadResult<Option<usize>> {
        if let Some(known) = self.edges.get(&edge.id) {
            return Ok(*known);
        }
        let index = match setting.curves.edge(edge)? {
            Some(shape) => {
                let name = self.name(edge);
                let index = self
                    .drafts
                    .curve(&name, edge.place(), shape.mapped(&setting.map))?;
                self.drafts.mark_edge(index);
                Some(index)
            }
            None => {
                self.passed.add("edge of a kind that is not read");
                None
            }
        };
        self.edges.insert(edge.id, index);
        Ok(index)
    }
}
