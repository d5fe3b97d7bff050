//! Nets for the tests of this crate.

use std::sync::Arc;

use glam::{DQuat, DVec3};
use netcast_dynamics::air::atmosphere::Medium;
use netcast_dynamics::air::wind::{LinearTable, Wind, power_law};
use netcast_dynamics::air::{Air, Attitude, BodyDrag};
use netcast_dynamics::body::{Body, Tie};
use netcast_dynamics::forces::bending::Bending;
use netcast_dynamics::forces::bilinear::Bilinear;
use netcast_dynamics::forces::body_drag::Shape;
use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::ground::{Footing, Ground, Hull, Spring};
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::orbit::Orbit;
use netcast_dynamics::forces::rope_drag::RopeDrag;
use netcast_dynamics::forces::rope_tension::damping_from_ratio;
use netcast_dynamics::forces::sheet_drag::SheetDrag;
use netcast_dynamics::forces::tabulated::Tabulated;
use netcast_dynamics::forces::viscoelastic::Viscoelastic;
use netcast_dynamics::simulate::{Frame, Live, Observer};
use netcast_dynamics::state::State;
use netcast_dynamics::system::{Environment, Segment, System, SystemParts};
use proptest::prelude::*;

/// A rope's properties.
#[derive(Debug, Clone, Copy)]
pub struct Material {
    pub axial_stiffness: f64,
    pub mass_per_length: f64,
    pub damping_ratio: f64,
}

/// The paper's rope: 10 mm, 1850 kg/m^3, 78 GPa.
pub fn paper_rope(damping_ratio: f64) -> Material {
    let area = std::f64::consts::PI * 0.01 * 0.01 / 4.0;
    Material { axial_stiffness: 78e9 * area, mass_per_length: 1850.0 * area, damping_ratio }
}

/// Parts to which segments can be added.
#[derive(Debug, Clone, Default)]
pub struct Net {
    pub parts: SystemParts,
    pub state: State,
}

impl Net {
    pub fn node(&mut self, position: DVec3, velocity: DVec3) -> usize {
        self.parts.mass.push(0.0);
        self.parts.held.push(false);
        self.parts.tractor.push(false);
        self.state.position.push(position);
        self.state.velocity.push(velocity);
        self.parts.mass.len() - 1
    }

    /// A segment of `rest_length`, its mass halved between its ends.
    pub fn segment(&mut self, a: usize, b: usize, rest_length: f64, m: Material) {
        let (stiffness, mass) = (m.axial_stiffness / rest_length, m.mass_per_length * rest_length);
        let damping = damping_from_ratio(m.damping_ratio, stiffness, mass);
        let breaking = Breaking::NEVER;
        self.parts.segments.push(Segment { ends: [a, b], rest_length, stiffness, damping, group: 0, breaking });
        self.parts.laws.resize(1, Law::Linear);
        self.parts.mass[a] += 0.5 * mass;
        self.parts.mass[b] += 0.5 * mass;
    }

    /// A straight rope of `count` segments from the origin along x, at rest and just not taut.
    pub fn rope(length: f64, count: usize, m: Material) -> Net {
        let mut net = Net::default();
        for i in 0..=count {
            net.node(DVec3::X * (length * i as f64 / count as f64), DVec3::ZERO);
        }
        for i in 0..count {
            net.segment(i, i + 1, length / count as f64, m);
        }
        net
    }

    /// A rigid body of this mass and inertia at `position`, moving at `velocity`, turned and turning as `rotation` says
    /// (rad/s in the world frame), that carries `ties` from where they are. Returns its centre.
    pub fn body(
        &mut self,
        position: DVec3,
        velocity: DVec3,
        mass: f64,
        inertia: DVec3,
        rotation: (DQuat, DVec3),
        ties: &[usize],
    ) -> usize {
        let centre = self.node(position, velocity);
        self.parts.mass[centre] = mass;
        let arm = |node: usize| rotation.0.inverse() * (self.state.position[node] - position);
        let ties: Vec<Tie> = ties.iter().map(|&node| Tie { node, arm: arm(node) }).collect();
        for tie in &ties {
            self.parts.mass[tie.node] = 0.0;
        }
        let body = Body { centre, inertia, ties };
        self.state.rotation.push(body.turning(rotation.0, rotation.1));
        self.parts.bodies.push(body);
        centre
    }

    /// Bends at every node between a segment and the one after it, EI in N m^2.
    pub fn stiffen(&mut self, bending_stiffness: f64) {
        let pairs = self.parts.segments.windows(2).filter(|pair| pair[0].ends[1] == pair[1].ends[0]);
        let bends = pairs.filter_map(|pair| {
            let [[a, b], [_, c]] = [pair[0].ends, pair[1].ends];
            let lengths = [pair[0].rest_length, pair[1].rest_length];
            Bending::new([a, b, c], lengths, bending_stiffness, 1e-5).ok()
        });
        self.parts.bends = bends.collect();
    }

    pub fn build(&self) -> System {
        self.parts.clone().build().expect("a valid net")
    }
}

/// Keeps every frame's time, positions and velocities.
#[derive(Default)]
pub struct Film {
    pub frames: Vec<(f64, Vec<DVec3>, Vec<DVec3>)>,
}

impl Observer for Film {
    fn step(&mut self, _: &Live) {}

    fn record(&mut self, frame: &Frame) {
        self.frames.push((frame.time, frame.position.to_vec(), frame.velocity.to_vec()));
    }
}

/// Any net: random nodes, ropes of several segments among them, some slack, some taut, moving.
pub fn any_net(damping_ratio: f64) -> impl Strategy<Value = Net> {
    let coordinate = || -1.0..1.0f64;
    let point = move || (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    let knots = prop::collection::vec((point(), point()), 3..12);
    let ropes = prop::collection::vec(
        (any::<prop::sample::Index>(), any::<prop::sample::Index>(), 1usize..6, 0.9..1.3f64),
        2..24,
    );
    (knots, ropes).prop_map(move |(knots, ropes)| {
        let mut net = Net::default();
        for (position, velocity) in knots {
            let node = net.node(position, 20.0 * velocity);
            net.parts.mass[node] = 0.2;
        }
        let count = net.parts.mass.len();
        for (a, b, pieces, slack) in ropes {
            let (a, b) = (a.index(count), b.index(count));
            let span = net.state.position[b] - net.state.position[a];
            if span.length() < 0.05 {
                continue;
            }
            let rest_length = slack * span.length() / pieces as f64;
            let mut last = a;
            for piece in 1..=pieces {
                let share = piece as f64 / pieces as f64;
                let next = if piece == pieces {
                    b
                } else {
                    let velocity = net.state.velocity[a].lerp(net.state.velocity[b], share);
                    net.node(net.state.position[a] + share * span, velocity)
                };
                let material = Material { axial_stiffness: 2e4, mass_per_length: 0.05, damping_ratio };
                net.segment(last, next, rest_length, material);
                last = next;
            }
        }
        net
    })
}

/// Standard gravity in a slanted direction and damping of 3 1/s.
pub fn surroundings() -> Environment {
    Environment { gravity: DVec3::new(1.0, -2.0, -9.5), mass_damping: 3.0, ..Environment::default() }
}

/// A stormy, watery air around `net`, in which all of it drags but every third group: its ropes, triangles between
/// knots, its bodies and a few nodes.
pub fn in_a_storm(net: &mut Net) {
    let mean = power_law(15.0, 10.0, 0.2, 1.5, 20.0);
    let fluctuation = LinearTable { first: 0.0, spacing: 1e-3, values: (0..40).map(wobble).collect() };
    let wind = Wind { direction: DVec3::new(0.6, 0.8, 0.0), mean, fluctuation };
    let rope = RopeDrag { diameter: 0.01, normal: None, tangential: 0.02, solidity: 0.2 };
    let drag = |group: usize| match group % 3 {
        0 => Some(rope),
        1 => Some(RopeDrag { normal: Some(1.2), solidity: 0.0, ..rope }),
        _ => None,
    };
    let body = |(index, body): (usize, &Body)| BodyDrag {
        node: body.centre,
        attitude: Attitude::Body(index),
        shape: Shape::Cylinder { diameter: 0.1, height: 0.2 },
    };
    let fixed = BodyDrag { node: 1, attitude: Attitude::Fixed(DQuat::IDENTITY), shape: Shape::Sphere(0.1) };
    net.parts.environment.air = Some(Air {
        ropes: (0..net.parts.laws.len()).map(drag).collect(),
        sheets: vec![
            SheetDrag { nodes: [0, 1, 2], coefficient: 1.17, area: 0.5 },
            SheetDrag { nodes: [2, 3, 1], coefficient: 0.5, area: 0.5 },
        ],
        bodies: net.parts.bodies.iter().enumerate().map(body).chain([fixed]).collect(),
        added_mass: 1.0,
        fastest: 100.0,
        ..Air::new(Medium::uniform(50.0, 1e-3), wind)
    });
}

/// Ground among `net` and an orbit around it: every node and the corners of every body touch the one, all feel the other.
pub fn on_the_ground_of_a_moon(net: &mut Net) {
    let spring = |mass: f64| Spring::bouncing(mass, 2e-3, 0.3);
    let has_hull = |node: usize| net.parts.bodies.iter().any(|body| body.centre == node);
    let heavy = net.parts.mass.iter().enumerate().filter(|(node, mass)| **mass > 0.0 && !has_hull(*node));
    let hulls = net.parts.bodies.iter().enumerate().flat_map(|(index, body)| {
        let mass = net.parts.mass[body.centre];
        [-0.1, 0.1].map(|side| Hull::new(index, body, mass, DVec3::new(side, 0.05, -0.1), 0.01, spring))
    });
    let ground = Ground {
        height: -0.2,
        friction: 0.5,
        nodes: heavy.map(|(node, &mass)| Footing { node, radius: 0.02, spring: spring(mass) }).collect(),
        hulls: hulls.collect(),
    };
    net.parts.environment.ground = Some(ground);
    net.parts.environment.orbit = Some(Orbit { mean_motion: 5.0, radial: DVec3::Z, along: DVec3::X });
}

fn wobble(i: i32) -> DVec3 {
    DVec3::new(f64::from(i % 7), f64::from(i % 5) - 2.0, f64::from(i % 3))
}

/// One of every law.
pub fn laws() -> Vec<Law> {
    let (strain, tension, back) = ([0.0, 0.02, 0.05], [0.0, 300.0, 1500.0], [0.0, 50.0, 1500.0]);
    let table = |unloading| Law::Tabulated(Arc::new(Tabulated::new(&strain, &tension, unloading).expect("a table")));
    vec![
        Law::Linear,
        Law::Bilinear(Bilinear { strain: 0.01, ratio: 3.0 }),
        Law::Bilinear(Bilinear { strain: 0.02, ratio: 0.1 }),
        table(None),
        table(Some(&back)),
        Law::Viscoelastic(Viscoelastic { ratio: 2.0, relaxation_time: 1e-3 }),
        Law::Strut,
    ]
}

/// Any net whose segments follow any law, one law a rope or another from segment to segment, and break here and there.
pub fn any_net_of_any_law(damping_ratio: f64) -> impl Strategy<Value = Net> {
    let of_each = prop::collection::vec((0..laws().len(), any::<bool>(), 0u8..10), 120);
    (any_net(damping_ratio), of_each).prop_map(|(mut net, of_each)| {
        net.parts.laws = laws();
        let mut group = 0;
        for (segment, (law, next, strength)) in net.parts.segments.iter_mut().zip(of_each) {
            group = if next { law } else { group };
            segment.group = group;
            segment.breaking = match strength {
                0 => Breaking { load: 200.0, ..Breaking::NEVER },
                1 => Breaking { strain: 0.03, ..Breaking::NEVER },
                2 => Breaking { cut_at: 1e-3, ..Breaking::NEVER },
                _ => Breaking::NEVER,
            };
        }
        net
    })
}
