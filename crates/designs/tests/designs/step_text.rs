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

    /// A hyperbola with both half axes.
    pub fn hyperbola(&mut self, frame: usize, axes: [f64; 2]) -> usize {
        self.entity(&format!(
            "HYPERBOLA('',#{frame},{:?},{:?})",
            axes[0], axes[1]
        ))
    }

    /// A parabola with the distance of its focus.
    pub fn parabola(&mut self, frame: usize, focus: f64) -> usize {
        self.entity(&format!("PARABOLA('',#{frame},{focus:?})"))
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

    /// The bound of a loop of edges.
    fn bound(&mut self, edges: &[StepEdge]) -> usize {
        let mut oriented = Vec::new();
        for (edge, forward) in edges {
            let sense = if *forward { "T" } else { "F" };
            let text = format!("ORIENTED_EDGE('',*,*,#{edge},.{sense}.)");
            oriented.push(format!("#{}", self.entity(&text)));
        }
        let ring = self.entity(&format!("EDGE_LOOP('',({}))", oriented.join(",")));
        self.entity(&format!("FACE_BOUND('',#{ring},.T.)"))
    }

    fn face_within(&mut self, name: &str, surface: usize, bounds: &[usize]) {
        let bounds: Vec<String> = bounds.iter().map(|bound| format!("#{bound}")).collect();
        let text = format!(
            "ADVANCED_FACE('{name}',({}),#{surface},.T.)",
            bounds.join(",")
        );
        let face = self.entity(&text);
        self.faces.push(face);
    }

    pub fn face(&mut self, name: &str, surface: usize, loops: &[Vec<StepEdge>]) {
        let bounds: Vec<usize> = loops.iter().map(|edges| self.bound(edges)).collect();
        self.face_within(name, surface, &bounds);
    }

    /// A face without a seam, from a loop to a vertex.
    pub fn face_to_vertex(
        &mut self,
        name: &str,
        surface: usize,
        edges: &[StepEdge],
        vertex: usize,
    ) {
        let bound = self.bound(edges);
        let point = self.entity(&format!("VERTEX_LOOP('',#{vertex})"));
        let point = self.entity(&format!("FACE_BOUND('',#{point},.T.)"));
        self.face_within(name, surface, &[bound, point]);
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
