//! STEP files of single faces, written line by line.

use std::fmt::Write;

/// A file of faces while it is written.
pub struct StepText {
    data: String,
    last: usize,
    faces: Vec<usize>,
}

/// An edge: its entity, and whether its loop passes it forward.
pub type StepEdge = (usize, bool);

impl StepText {
    pub fn new() -> Self {
        Self {
            data: String::new(),
            last: 0,
            faces: Vec::new(),
        }
    }

    pub fn entity(&mut self, text: &str) -> usize {
        self.last += 1;
        writeln!(self.data, "#{} = {text};", self.last).unwrap();
        self.last
    }

    fn triple(&mut self, kind: &str, [x, y, z]: [f64; 3]) -> usize {
        self.entity(&format!("{kind}('',({x:?},{y:?},{z:?}))"))
    }

    pub fn point(&mut self, at: [f64; 3]) -> usize {
        self.triple("CARTESIAN_POINT", at)
    }

    pub fn vertex(&mut self, at: [f64; 3]) -> usize {
        let point = self.point(at);
        self.entity(&format!("VERTEX_POINT('',#{point})"))
    }

    pub fn frame(&mut self, origin: [f64; 3], axis: [f64; 3], across: [f64; 3]) -> usize {
        let origin = self.point(origin);
        let axis = self.triple("DIRECTION", axis);
        let across = self.triple("DIRECTION", across);
        self.entity(&format!(
            "AXIS2_PLACEMENT_3D('',#{origin},#{axis},#{across})"
        ))
    }

    /// The edge on a curve from one vertex to another.
    pub fn edge(&mut self, [from, to]: [usize; 2], curve: usize) -> usize {
        self.entity(&format!("EDGE_CURVE('',#{from},#{to},#{curve},.T.)"))
    }

    pub fn line(&mut self, ends: [usize; 2], from: [f64; 3], to: [f64; 3]) -> usize {
        let point = self.point(from);
        let way = [0, 1, 2].map(|i| to[i] - from[i]);
        let direction = self.triple("DIRECTION", way);
        let vector = self.entity(&format!("VECTOR('',#{direction},1.)"));
        let line = self.entity(&format!("LINE('',#{point},#{vector})"));
        self.edge(ends, line)
    }

    /// The closed edge around a circle or an ellipse, given by its entity, through its point at the angle 0.
    pub fn ring(&mut self, curve: usize, start: [f64; 3]) -> usize {
        let vertex = self.vertex(start);
        self.edge([vertex, vertex], curve)
    }

    pub fn circle(&mut self, frame: usize, radius: f64) -> usize {
        self.entity(&format!("CIRCLE('',#{frame},{radius:?})"))
    }

    pub fn ellipse(&mut self, frame: usize, radii: [f64; 2]) -> usize {
        self.entity(&format!(
            "ELLIPSE('',#{frame},{:?},{:?})",
            radii[0], radii[1]
        ))
    }

    /// The straight edges of a polygon.
    pub fn polygon(&mut self, corners: &[[f64; 3]]) -> Vec<StepEdge> {
        let vertices: Vec<usize> = corners.iter().map(|at| self.vertex(*at)).collect();
        let count = corners.len();
        let edge = |k: usize, text: &mut Self| {
            let next = (k + 1) % count;
            text.line([vertices[k], vertices[next]], corners[k], corners[next])
        };
        (0..count).map(|k| (edge(k, self), true)).collect()
    }

    pub fn face(&mut self, name: &str, surface: usize, loops: &[Vec<StepEdge>]) {
        let mut bounds = Vec::new();
        for edges in loops {
            let mut oriented = Vec::new();
            for (edge, forward) in edges {
                let sense = if *forward { "T" } else { "F" };
                let text = format!("ORIENTED_EDGE('',*,*,#{edge},.{sense}.)");
                oriented.push(format!("#{}", self.entity(&text)));
            }
            let ring = self.entity(&format!("EDGE_LOOP('',({}))", oriented.join(",")));
            bounds.push(format!(
                "#{}",
                self.entity(&format!("FACE_BOUND('',#{ring},.T.)"))
            ));
        }
        let text = format!(
            "ADVANCED_FACE('{name}',({}),#{surface},.T.)",
            bounds.join(",")
        );
        let face = self.entity(&text);
        self.faces.push(face);
    }

    /// The whole file, in millimetres.
    pub fn finish(mut self) -> String {
        let faces: Vec<String> = self.faces.iter().map(|face| format!("#{face}")).collect();
        let shell = self.entity(&format!("OPEN_SHELL('',({}))", faces.join(",")));
        let model = self.entity(&format!("SHELL_BASED_SURFACE_MODEL('',(#{shell}))"));
        let unit = self.entity("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))");
        let context = self.entity(&format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((#{unit})) REPRESENTATION_CONTEXT('',''))"
        ));
        self.entity(&format!(
            "MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#{model}),#{context})"
        ));
        format!(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n\
             FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
            self.data
        )
    }
}
