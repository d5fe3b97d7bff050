//! Scenarios that together hold everything a scenario can hold; small, and short.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use netcast::Document;
use netcast::scenario::Source;
use netcast::scenario::schema;
use netcast::scenario::tree::{Tree, Value};
use serde_json::{Map, Value as Json};

/// What a scenario is called, and its text.
pub const SCENARIOS: [(&str, &str); 41] = [
    (
        "space web, everything on board",
        r#"
title = "Everything on board"
web.space.side = "1 m"
canopy.links = { material = "aramid cloth", side = "0.1 m", thickness = "5 mm", density = 2000, elastic_modulus = "9 GPa", damping_ratio = 0.1, porosity = 0.05 }
payload.cylinder = { diameter = "60 mm", height = "66 mm", density = 2710 }
sensor.cylinder.mass = "0.2 kg"
tractor.cylinder = { diameter = "50 mm", height = "0.1 m", density = 7800 }
traction_rope = { length = "0.5 m", count = 2 }
launch = { axial_speed = "50 m/s", radial_speed = "30 m/s", elevation = "60 deg", azimuth = "20 deg" }
environment = { gravity = "3.7 m/s^2", damping = "8 1/s" }
measure.target_diameter = "1 m"
record = { every = "0.1 ms", fields_every = "0.3 ms" }

[rope]
material = "aramid rope"
diameter = "3 mm"
density = 1440
elastic_modulus = "70 GPa"
damping_time = "2 us"
pretension = 0
strength = "5 kN"
knot_reduction = 0.3

[stow.bag]
radius = "0.2 m"
depth = "0.1 m"
tractor_radius = "0.25 m"
tractor_gap = "0.2 m"

[solve]
duration = "1.95 ms"
segment_length = "0.2 m"
step_fraction = 0.3
energy_tolerance = 0.5
web_energy_tolerance = 0.5
on_energy_error = "flag"
"#,
    ),
    (
        "space web, the other bodies",
        r#"
web.space.side = "1 m"
canopy.links = { material = "nylon cloth", thickness = "0.3 mm" }
payload.cylinder.mass = "0.1 kg"
sensor.cylinder = { diameter = "50 mm", height = "50 mm", density = 2000 }
tractor.particle.mass = "1 kg"
stow.scale.factor = 0.5
launch.radial_speed = "30 m/s"
rope = { diameter = "3 mm", material = "polyester rope", elastic_modulus = "7 GPa", damping_ratio = 0.2 }
solve = { duration = "2 ms", segment_length = "0.2 m", on_energy_error = "stop" }
record.every = "0.2 ms"
"#,
    ),
    (
        "space web, bodies without size",
        r#"
web.space.side = "1 m"
payload.particle = { mass = "0.1 kg", diameter = "0.3 m" }
sensor.particle = { mass = "0.2 kg", diameter = "50 mm" }
environment.air.solidity = "web"
rope = { diameter = "3 mm", material = "LCP rope", elastic_modulus = "7 GPa" }
solve = { duration = "2 ms", segment_length = "0.2 m" }
record.every = "0.2 ms"
"#,
    ),
    (
        "traditional web, no two tractors alike",
        r#"
web.traditional = { side = "1 m", cells_per_side = 3 }
rope = { diameter = "3 mm", material = "UHMWPE rope", elastic_modulus = "7 GPa" }
ropes.thick = { material = "steel wire rope", diameter = "6 mm", density = 1440, elastic_modulus = "7 GPa", strength = "9 kN", knot_reduction = 0.2, damping_ratio = 0 }
assign.outline = "thick"
tractor.cylinder.mass = "0.4 kg"
stow.bag.radius = "0.3 m"
launch = { axial_speed = "20 m/s", radial_speed = "20 m/s" }
solve = { duration = "4 ms", segment_length = "0.2 m" }
record.every = "0.2 ms"

[[tractors]]
corner = 2
particle = { mass = "0.9 kg", diameter = "60 mm" }
axial_speed = "25 m/s"
radial_speed = "15 m/s"
elevation = "80 deg"
azimuth = "10 deg"

[[tractors]]
corner = 5
cylinder = { diameter = "50 mm", height = "80 mm", density = 7800 }

[[tractors]]
corner = 6
cylinder.mass = "0.7 kg"
"#,
    ),
    (
        "topological web, pulled while it hangs",
        r#"
web.topological = { side = "1 m", hexagon_side = "0.1 m" }
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
ropes.soft = { diameter = "3 mm", material = "nylon rope", damping_time = "5 us" }
ropes.thin = { diameter = "2 mm", material = "UHMWPE rope", elastic_modulus = "7 GPa" }
assign = { radial = "soft", "ring 1" = "thin", "outline link 1-2" = "soft" }
tractor.particle.mass = "0.5 kg"
traction_rope.length = "0.4 m"
launch.axial_speed = "-30 m/s"
solve = { duration = "3 ms", segment_length = "0.2 m" }
record.every = "0.2 ms"
"#,
    ),
    (
        "square net held at its corners, falling",
        r#"
web.square = { side = "2 m", mesh = "0.5 m", segments_per_mesh = 2 }
rope = { diameter = "3 mm", material = "nylon rope", pretension = "20 N" }
ropes.lashing = { diameter = "4 mm", material = "polyester rope", elastic_modulus = "1 GPa", pretension = "40 N" }
assign.outline = "lashing"
hold.corners = true
solve.duration = "40 ms"
record.every = "2 ms"
"#,
    ),
    (
        "square net, thrown, recorded out of step",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
tractor.particle.mass = "0.3 kg"
stow.scale.factor = 0.25
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
environment.gravity = 0
solve.duration = "50 ms"
record = { every = "7 ms", fields_every = "14 ms" }

[rope]
diameter = "3 mm"
material = "steel wire rope"
density = 1140
elastic_modulus = "5 GPa"
law.bilinear = { strain = 0.001, second_modulus = "1 GPa" }
breaking = { load = "2 kN", strain = 0.2 }
"#,
    ),
    (
        "graph, stowed from a file, one knot held",
        r#"
web.graph = { nodes = "nodes.csv", ropes = "ropes.csv", outline = ["a", "b", "c", "d"], corners = ["a", "b", "c"] }
stow.file.path = "stowed.csv"
points = { B = "m" }
hold = { corners = false, nodes = ["d"] }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
ropes.thick = { diameter = "5 mm", material = "aramid rope", density = 1140, elastic_modulus = "1 GPa" }
tractor.particle.mass = "0.3 kg"
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "60 ms", segment_length = "0.2 m" }
record.every = "4 ms"
"#,
    ),
    (
        "square net with a drawstring",
        r#"
web.square = { side = "2 m", mesh = "0.5 m", gathering = { every = 2, excess = "10 %" } }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "0.3 kg"
stow.bag.radius = "0.3 m"
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve.duration = "30 ms"
record.every = "2 ms"
"#,
    ),
    (
        "octagon by its side",
        r#"
web.polygon = { sides = 8, side = "0.8 m", mesh = "0.3 m" }
tractor.particle.mass = "0.3 kg"
stow.roll.container.box = { width = "0.6 m", breadth = "0.6 m", height = "0.5 m" }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.3 m" }
record.every = "2 ms"

[rope]
diameter = "3 mm"
density = 1140
elastic_modulus = "5 GPa"
law.viscoelastic = { instantaneous_modulus = "9 GPa", relaxation_time = "10 ms" }
"#,
    ),
    (
        "triangle by its diameter, held",
        r#"
web.polygon = { sides = 3, diameter = "2 m", mesh = "0.2 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa", pretension = "20 N", law.strut = {} }
hold.corners = true
solve = { duration = "20 ms", segment_length = "0.2 m" }
record.every = "2 ms"
"#,
    ),
    (
        "spider's web round a hub",
        r#"
web.radial = { diameter = "2 m", radials = 9, rings = 4, hub_diameter = "0.4 m", corners = 3 }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa", law.linear = {} }
tractor.particle.mass = "0.3 kg"
stow.star.container.box = { width = "0.8 m", breadth = "0.8 m", height = "0.3 m" }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"
"#,
    ),
    (
        "diamond net by its angle",
        r#"
web.diamond = { mesh = "0.25 m", meshes_wide = 5, meshes_high = 4, angle = "70 deg" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa", law.table.file = "belt.csv" }
tractor.particle.mass = "0.3 kg"
stow.layers.container.box = { width = "0.5 m", breadth = "0.5 m", height = "0.4 m" }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"
"#,
    ),
    (
        "diamond net by its hanging ratio, falling",
        r#"
web.diamond = { mesh = "0.25 m", meshes_wide = 3, meshes_high = 4, hanging_ratio = 0.6 }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
hold.nodes = ["knot 5"]
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"
"#,
    ),
    (
        "square net hung up, loaded, then pulled at",
        r#"
web.square = { side = "2 m", mesh = "0.5 m", segments_per_mesh = 2 }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
hold.corners = true
environment.air = {}
environment.wind.series.file = "wind.csv"
load.middle = { force = ["0 N", "3 N", "-20 N"], points = ["B"], nodes = ["knot 8"] }
load.pull = { force = ["30 N", 0, 0], nodes = ["knot 12"], ramp = "10 ms" }
load.snow = { force_per_length = [0, 0, "-2 N/m"], class = "inner" }
drive.edge = { file = "path.csv", nodes = ["knot 3"] }
drive.side = { path = [{ time = "5 ms", by = ["0.1 m", 0, "0.1 m"] }, { time = "15 ms", by = [0, 0, 0] }], points = ["D"] }
drive.hold = { path = [{ time = "1 ms", by = [0, 0, 0] }], corners = true }
solve = { duration = "30 ms", static = { tolerance = 1e-5, max_iterations = 100000, then_run = true } }
record.every = "2 ms"
"#,
    ),
    (
        "square net hung up, nothing else",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
hold.corners = true
solve.static = { then_run = false }
"#,
    ),
    (
        "square net thrown by drives, with drag that does not change",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
tractor.cylinder = { diameter = "40 mm", height = "60 mm", mass = "0.3 kg" }
traction_rope = { length = "0.3 m", tied_at = "rear" }
load.drag = { force = [0, 0, "-2 N"], corners = true, tractors = true }
load.lift = { force = [0, 0, "4 N"], corners = false, tractors = false, points = ["B"] }
drive.up = { path = [{ time = "20 ms", by = [0, 0, "0.5 m"] }], tractors = true, corners = false }
drive.middle = { path = [{ time = "10 ms", by = [0, 0, "0.1 m"] }], tractors = false, points = ["B"] }
stow.scale.factor = 0.5
solve.duration = "30 ms"
record.every = "2 ms"
"#,
    ),
    (
        "graph that moves by itself",
        r#"
web.graph = { nodes = "moving.csv", ropes = "ropes.csv" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
ropes.thick = { diameter = "5 mm", material = "LCP rope", density = 1140, elastic_modulus = "1 GPa" }
solve.duration = "12 ms"
"#,
    ),
    (
        "graph with a rope of each law, and some that break",
        r#"
web.graph = { nodes = "moving.csv", ropes = "laws.csv" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa", strength = "60 N", breaking = {} }
environment.air = {}
environment.wind = { speed = "8 m/s", turbulence.dryden = { deviation = "2 m/s", length_scale = "5 m" } }
solve = { duration = "12 ms", segment_length = "0.3 m" }

[ropes.linear]
diameter = "3 mm"
density = 1140
elastic_modulus = "1 GPa"
strength = "1 kN"
knot_reduction = 0.3
law.linear = {}
breaking = { load = "30 N", strain = 0.1 }

[ropes.bilinear]
diameter = "3 mm"
density = 1140
elastic_modulus = "1 GPa"
law.bilinear = { strain = 0.01, second_modulus = "3 GPa" }
breaking.strain = 0.03

[ropes.table]
diameter = "3 mm"
density = 1140
elastic_modulus = "1 GPa"
law.table.file = "belt.csv"

[ropes.viscoelastic]
diameter = "3 mm"
density = 1140
elastic_modulus = "1 GPa"
law.viscoelastic = { instantaneous_modulus = "3 GPa", relaxation_time = "2 ms" }

[ropes.strut]
diameter = "3 mm"
density = 1140
elastic_modulus = "1 GPa"
law.strut = {}
"#,
    ),
    (
        "space web that spins, spheres and boxes",
        r#"
web.space.side = "1 m"
payload.sphere = { diameter = "40 mm", density = 2000 }
sensor.box = { width = "40 mm", depth = "30 mm", height = "20 mm", density = 2000 }
tractor.sphere = { diameter = "60 mm", density = 7800 }
traction_rope = { length = "0.3 m", tied_at = "rear" }
stow.bag.radius = "0.2 m"
launch = { axial_speed = "30 m/s", radial_speed = "10 m/s", spin = "300 rpm", attitude = "axis" }
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
solve = { duration = "3 ms", segment_length = "0.2 m" }
record.every = "0.2 ms"

[[tractors]]
corner = 1
tied_at = "front"
[[tractors]]
corner = 2
tied_at = "centre"
[[tractors]]
corner = 3
tie_point = ["10 mm", 0, "-20 mm"]
[[tractors]]
corner = 4
sphere = { diameter = "50 mm", density = 7800 }
[[tractors]]
corner = 5
box = { width = "40 mm", depth = "30 mm", height = "20 mm", density = 7800 }
tied_at = "rear"
"#,
    ),
    (
        "space web from tubes, fired by chance",
        r#"
web.space.side = "1 m"
payload.sphere = { diameter = "40 mm", mass = "0.1 kg" }
sensor.box = { width = "40 mm", depth = "30 mm", height = "20 mm", mass = "0.1 kg" }
tractor.sphere = { diameter = "60 mm", mass = "0.5 kg" }
traction_rope = { length = "0.3 m", tied_at = "front" }
stow.bag.radius = "0.2 m"
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
solve = { duration = "10 ms", segment_length = "0.2 m" }
record.every = "0.5 ms"

[launch.tube]
stroke = "30 mm"
cant = "20 deg"
force_over_stroke = { at = [0, "20 mm"], force = ["6 kN", "3 kN"] }

[launch.scatter]
speed = "5 %"
angle = "1 deg"
delay = "0.4 ms"
seed = 4

[[tractors]]
corner = 2
sphere = { diameter = "50 mm", mass = "0.4 kg" }
delay = "1 ms"
[[tractors]]
corner = 3
box = { width = "40 mm", depth = "30 mm", height = "20 mm", mass = "0.4 kg" }
"#,
    ),
    (
        "space web under covers, its tractors let go in turn",
        r#"
web.space.side = "1 m"
payload.box = { width = "40 mm", depth = "30 mm", height = "20 mm", density = 2000 }
sensor.sphere = { diameter = "40 mm", density = 2000 }
tractor.box = { width = "40 mm", depth = "30 mm", height = "60 mm", density = 7800 }
traction_rope = { length = "0.3 m", tie_point = ["5 mm", "5 mm", "-30 mm"] }
stow.bag.radius = "0.2 m"
launch = { axial_speed = "50 m/s", radial_speed = "10 m/s", attitude = "flight" }
covers = [{ opens = "1.3 ms" }, { opens = "2 ms", nodes = ["centre of canopy 1"] }]
tractors = [{ corner = 1, delay = "0.7 ms" }, { corner = 2, delay = "1.5 ms" }]
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
solve = { duration = "4 ms", segment_length = "0.2 m" }
record.every = "0.2 ms"
"#,
    ),
    (
        "square net in layers, tied and stitched",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "0.3 kg"
traction_rope.length = "0.5 m"
stow.layers.container.box = { width = "0.6 m", breadth = "0.6 m", height = "0.5 m" }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"

[[break_ties]]
tractors = true
corners = false
breaking_load = "100 N"
breaking_strain = "20 %"

[[break_ties]]
tractors = false
corners = true
nodes = ["knot 8"]
points = ["B"]
pairs = [["knot 7", "knot 9"]]
length = "1 m"
breaking_load = "50 N"

[[stitches]]
class = "outline"
reach = "80 mm"
every = 2
breaking_load = "5 N"

[[stitches]]
pairs = [["knot 3", "knot 4"]]
length = "1 m"
breaking_load = "5 N"
breaking_strain = "8 %"
"#,
    ),
    (
        "space web from tubes, by a force over time, from a file",
        r#"
web.space.side = "1 m"
payload.box = { width = "40 mm", depth = "30 mm", height = "20 mm", mass = "0.1 kg" }
sensor.sphere = { diameter = "40 mm", mass = "0.1 kg" }
tractor.box = { width = "40 mm", depth = "30 mm", height = "60 mm", mass = "0.5 kg" }
traction_rope = { length = "0.3 m", tied_at = "centre" }
stow.bag.radius = "0.2 m"
launch.tube = { stroke = "20 mm", force_over_time.file = "pulse.csv" }
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
solve = { duration = "6 ms", segment_length = "0.2 m" }
record.every = "0.5 ms"
"#,
    ),
    (
        "square net from tubes, by a force over the stroke, from a file",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
environment.air = { density = "1000 kg/m^3", viscosity = "1 mPa s", added_mass = 1, solidity = 0.2 }
environment.wind = { speed = "2 m/s", turbulence.von_karman = { intensity = 0.1, length_scale = "5 m" } }
tractor.particle = { mass = "0.3 kg", diameter = "50 mm" }
traction_rope.length = "0.3 m"
stow.bag.radius = "0.2 m"
launch.tube = { stroke = "20 mm", force_over_stroke.file = "spring.csv" }
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
solve = { duration = "6 ms", segment_length = "0.2 m" }
record.every = "0.5 ms"
"#,
    ),
    (
        "square net from tubes, by a force over time",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
tractor.particle.mass = "0.3 kg"
traction_rope.length = "0.3 m"
stow.bag.radius = "0.2 m"
launch.tube = { stroke = "20 mm", force_over_time = { at = [0, "1 ms"], force = ["2 kN", "1 kN"] } }
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
solve = { duration = "6 ms", segment_length = "0.2 m" }
record.every = "0.5 ms"
"#,
    ),
    (
        "space web of rigid plates",
        r#"
web.space.side = "1 m"
canopy.rigid = { side = "0.1 m", thickness = "5 mm", density = 2000, porosity = 0.1 }
payload.cylinder = {}
sensor.particle.mass = "0.2 kg"
tractor.particle.mass = "1 kg"
environment.air = { altitude = "300 m", normal_coefficient = 1.1, tangential_coefficient = 0.03, sheet_coefficient = 1.2, buoyancy = true }
environment.wind.speed = "6 m/s"
environment.wind.azimuth = "30 deg"
environment.wind.muzzle_height = "2 m"
environment.wind.power = { exponent = 0.2, reference_height = "8 m" }
environment.wind.gust = { speed = "5 m/s", at = "0.5 ms", duration = "1 ms", azimuth = "90 deg" }
environment.wind.turbulence.von_karman = { deviation = "1 m/s", length_scale = "20 m", seed = 3 }
stow.scale.factor = 0.5
launch.radial_speed = "30 m/s"
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa", bending_stiffness = "0.002 N m^2" }
solve = { duration = "2 ms", segment_length = "0.2 m" }
record.every = "0.2 ms"
"#,
    ),
    (
        "space web of orthotropic plates, tied over patches",
        r#"
web.space.side = "1 m"
payload.cylinder.mass = "0.2 kg"
sensor.cylinder.mass = "0.2 kg"
tractor.particle.mass = "1 kg"
stow.bag = { radius = "0.2 m", depth = "0.1 m" }
launch.radial_speed = "30 m/s"
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
ropes.stiff = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa", bending_stiffness = 0.001 }
assign.radial = "stiff"
environment.air.buoyancy = false
environment.wind.speed = "6 m/s"
environment.wind.logarithmic = { roughness = "10 cm", reference_height = "8 m" }
environment.wind.turbulence.dryden = { intensity = 0.2, length_scale = "20 m", seed = 3 }
solve = { duration = "2 ms", segment_length = "0.1 m" }
record.every = "0.2 ms"

[canopy.membrane]
material = "aramid cloth"
side = "0.1 m"
thickness = "5 mm"
density = 2000
elastic_modulus = "9 GPa"
elastic_modulus_across = "5 GPa"
poisson_ratio = 0.2
shear_modulus = "1 GPa"
fibre_angle = "30 deg"
porosity = 0.04
fineness = 4
wrinkles = false
bending = "plate"
tie_radius = "26 mm"
damping_ratio = 0.1
strength = "300 MPa"
"#,
    ),
    (
        "space web of cloth",
        r#"
web.space.side = "1 m"
canopy.membrane = { material = "nylon cloth", thickness = "0.3 mm", wrinkles = true, bending = "none", damping_time = "2 us" }
tractor.particle.mass = "1 kg"
stow.bag.radius = "0.2 m"
launch.radial_speed = "30 m/s"
rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
solve = { duration = "2 ms", segment_length = "0.2 m" }
record.every = "0.2 ms"
"#,
    ),
    (
        "square net in walls, disturbed",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "0.3 kg"
traction_rope.length = "0.5 m"
stow.zigzag = { along = "rings", spacing = "5 mm", tractor_radius = "0.2 m", tractor_gap = "0.1 m", container.cylinder = { radius = "0.2 m", height = "0.4 m" } }
stow.imperfection = { scatter = "4 mm", twist = "20 deg", slack = "3 %", seed = 7, late_sector = { width = "80 deg", until = "3 ms", direction = "20 deg" } }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"
"#,
    ),
    (
        "square net folded along lines into a box",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "0.3 kg"
traction_rope.length = "0.5 m"
stow.zigzag = { along = "lines", container.box = { width = "0.4 m", breadth = "0.3 m", height = "0.4 m" } }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"
"#,
    ),
    (
        "octagon wound to a star",
        r#"
web.polygon = { sides = 8, side = "0.8 m", mesh = "0.3 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "0.3 kg"
traction_rope.length = "0.5 m"
stow.star = { arms = 4, spacing = "3 mm", tractor_radius = "0.25 m", tractor_gap = "0.1 m", container.cylinder = { radius = "0.3 m", height = "0.3 m" } }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.3 m" }
record.every = "2 ms"
"#,
    ),
    (
        "square net rolled up",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "0.3 kg"
traction_rope.length = "0.5 m"
stow.roll = { spacing = "4 mm", tractor_radius = "0.2 m", tractor_gap = "0.1 m", container.cylinder = { radius = "0.15 m", height = "0.4 m" } }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"
"#,
    ),
    (
        "square net in layers",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "0.3 kg"
traction_rope.length = "0.5 m"
stow.layers = { spacing = "4 mm", tractor_radius = "0.2 m", tractor_gap = "0.05 m", container.cylinder = { radius = "0.3 m", height = "0.3 m" } }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"
"#,
    ),
    (
        "thrown from the ground",
        r#"
web.square = { side = "1 m", mesh = "0.5 m" }
rope = { diameter = "4 mm", density = 1140, elastic_modulus = "1 GPa", damping_ratio = 0.1 }
tractor.box = { width = "50 mm", depth = "60 mm", height = "80 mm", mass = "0.3 kg" }
traction_rope = { length = "0.2 m", tied_at = "rear" }
stow.scale.factor = 0.4
launch = { axial_speed = "0.1 m/s", radial_speed = "20 m/s" }
environment.ground = { friction = 0.4, restitution = 0.3, contact_time = "0.5 ms" }
solve = { duration = "40 ms", segment_length = "0.1 m", on_energy_error = "flag" }
record.every = "2 ms"
"#,
    ),
    (
        "dropped onto the ground",
        r#"
web.square = { side = "1 m", mesh = "0.5 m" }
rope = { diameter = "4 mm", density = 1140, elastic_modulus = "1 GPa", damping_ratio = 0.1 }
tractor.sphere = { diameter = "60 mm", mass = "0.3 kg" }
environment.ground.height = "-50 mm"
solve = { duration = "150 ms", segment_length = "0.25 m", on_energy_error = "flag" }
record.every = "10 ms"
"#,
    ),
    (
        "let go beside the orbit of another planet",
        r#"
web.square = { side = "1 m", mesh = "0.5 m" }
rope = { diameter = "4 mm", density = 1140, elastic_modulus = "1 GPa", damping_ratio = 0.1 }
environment.orbit.mean_motion = "2 rad/s"
solve = { duration = "40 ms", segment_length = "0.25 m", on_energy_error = "flag" }
record.every = "2 ms"
"#,
    ),
    (
        "thrown beside an orbit",
        r#"
web.square = { side = "1 m", mesh = "0.5 m" }
rope = { diameter = "4 mm", density = 1140, elastic_modulus = "1 GPa", damping_ratio = 0.1 }
tractor.particle.mass = "0.3 kg"
stow.scale.factor = 0.4
launch = { axial_speed = "3 m/s", radial_speed = "5 m/s", elevation = "20 deg" }
environment.orbit.altitude = "600 km"
solve = { duration = "40 ms", segment_length = "0.25 m", on_energy_error = "flag" }
record.every = "2 ms"
"#,
    ),
    (
        "square net drawn in to a ring",
        r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa" }
tractor.particle.mass = "0.3 kg"
traction_rope.length = "0.5 m"
stow.prescribed = { radius = "0.2 m", depth = "0.3 m", time = "0.5 s", gravity = "5 m/s^2", damping = "8 1/s", rest = "1 %", longest = "4 s", tractor_radius = "0.25 m", tractor_gap = "0.1 m" }
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "30 ms", segment_length = "0.25 m" }
record.every = "2 ms"
"#,
    ),
    (
        "slack graph led by its corners and its middle",
        r#"
web.graph = { nodes = "nodes.csv", ropes = "slack.csv", outline = ["a", "b", "c", "d"], corners = ["a", "b", "c", "d"] }
points.B = "m"
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
tractor.particle.mass = "0.3 kg"
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "40 ms", segment_length = "0.2 m" }
record.every = "2 ms"

[stow.prescribed]
radius = "1.4 m"
drive.edge = { corners = true, tractors = false, path = [{ time = "0.3 s", by = [0, 0, "-0.1 m"] }] }
drive.middle = { points = ["B"], nodes = ["m"], path = [{ time = "0.2 s", by = [0, 0, "-0.2 m"] }] }
"#,
    ),
    (
        "slack graph led by its tractors, from a file",
        r#"
web.graph = { nodes = "nodes.csv", ropes = "slack.csv", corners = ["a", "b", "c", "d"] }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
tractor.particle.mass = "0.3 kg"
launch = { axial_speed = "20 m/s", radial_speed = "10 m/s" }
solve = { duration = "40 ms", segment_length = "0.2 m" }
record.every = "2 ms"
stow.prescribed = { radius = "1.3 m", drive.all = { tractors = true, corners = false, file = "path.csv" } }
"#,
    ),
];

/// The files that scenarios name: every column that such files can have.
const FILES: [(&str, &str); 11] = [
    ("nodes.csv", "id,x,y,z,mass\na,1,1,0,0\nb,-1,1,0,0\nc,-1,-1,0,0\nd,1,-1,0,0\nm,0,0,0,0.1\n"),
    (
        "moving.csv",
        "id,x,y,z,mass,fixed,vx,vy,vz\na,1,1,0,0,1,0,0,0\nb,-1,1,0,0,0,-3,0,8\nc,-1,-1,0,0.2,0,0,0,0\n\
         d,1,-1,0,0,0,4,-4,0\nm,0,0,0,0.1,0,0,0,20\n",
    ),
    (
        "ropes.csv",
        "a,b,class,rope,rest_length,pretension,segments\na,b,outline,,,,\nb,c,outline,thick,2.1,,\nc,d,outline,,,5,\n\
         d,a,outline,,,,3\na,m,radial,,,,\nb,m,radial,,,,\nc,m,radial,,,,\nd,m,radial,,,,\n",
    ),
    (
        "laws.csv",
        "a,b,rope,segments\na,b,linear,\nb,c,bilinear,\nc,d,table,\nd,a,viscoelastic,\na,m,strut,1\nb,m,table,\n\
         c,m,,\nd,m,viscoelastic,\n",
    ),
    ("slack.csv", "a,b,rest_length\na,b,2.2\nb,c,2.2\nc,d,2.2\nd,a,2.2\na,m,1.5\nb,m,1.5\nc,m,1.5\nd,m,1.5\n"),
    ("belt.csv", "strain,tension,unloading\n0,0,0\n0.02,200,20\n0.1,1500,1500\n"),
    ("path.csv", "t,x,y,z\n0,0,0,0\n0.004,0,0,0.05\n0.02,0.1,0,0.05\n"),
    ("stowed.csv", "id,x,y,z\na,0.4,0.4,0\nb,-0.4,0.4,0\nc,-0.4,-0.4,0\nd,0.4,-0.4,0\nm,0,0,-0.3\n"),
    ("pulse.csv", "time,force\n0,0\n0.001,2000\n0.003,0\n"),
    ("wind.csv", "t,vx,vy,vz\n0,8,0,0\n0.01,4,3,1\n0.025,9,0,0\n"),
    ("spring.csv", "stroke,force\n0,2000\n0.02,0\n"),
];

/// Puts the files that scenarios name into `folder`.
pub fn write_files(folder: &Path) {
    for (name, text) in FILES {
        fs::write(folder.join(name), text).unwrap();
    }
}

/// Reads a scenario, its files in `folder`.
pub fn read(text: &str, folder: &Path) -> Document {
    let source = Source { name: "scenario.toml".into(), text: text.into() };
    Document::parse(source, folder, &[]).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Every key, variant and choice that the schema knows and no scenario has, and every optional section that none does
/// without. What is added to the schema is missing here until a scenario has it.
pub fn missing() -> Vec<String> {
    let mut missing = BTreeSet::new();
    let trees: Vec<Tree> =
        SCENARIOS.iter().map(|(name, text)| Tree::parse(text).unwrap_or_else(|_| panic!("{name}"))).collect();
    let roots: Vec<&Value> = trees.iter().map(|tree| &tree.root.value).collect();
    walk(schema().as_object().unwrap(), "", &roots, &mut missing);
    let required: Vec<&Json> = schema()["required"].as_array().unwrap().iter().collect();
    for key in
        schema()["properties"].as_object().unwrap().keys().filter(|key| !required.contains(&&Json::from(&key[..])))
    {
        if roots.iter().all(|root| child(root, key).is_some()) {
            missing.insert(format!("a scenario without {key}"));
        }
    }
    missing.into_iter().collect()
}

fn child<'v>(value: &'v Value, key: &str) -> Option<&'v Value> {
    value.as_table()?.0.iter().find(|entry| entry.key == key).map(|entry| &entry.node.value)
}

/// Looks for what `schema` allows at `path` among the values that scenarios have there.
fn walk(schema: &Map<String, Json>, path: &str, values: &[&Value], missing: &mut BTreeSet<String>) {
    let mut below = |step: String, schema: &Json, values: Vec<&Value>| {
        let path = format!("{path}{step}");
        match schema.as_object() {
            _ if values.is_empty() => drop(missing.insert(path)),
            Some(schema) => walk(schema, &path, &values, missing),
            None => {}
        }
    };
    let named = |key: &str| values.iter().filter_map(|value| child(value, key)).collect();
    let objects = |of: &str| schema.get(of).and_then(Json::as_object).into_iter().flatten();
    for (key, content) in objects("properties") {
        below(format!(".{key}"), content, named(key));
    }
    for branch in schema.get("oneOf").and_then(Json::as_array).into_iter().flatten() {
        for (variant, content) in branch.get("properties").and_then(Json::as_object).into_iter().flatten() {
            below(format!(".{variant}"), content, named(variant));
        }
        if let Some(choice) = branch.get("const") {
            below(format!(" = {choice}"), &Json::Null, equal(values, choice));
        }
    }
    for choice in schema.get("enum").and_then(Json::as_array).into_iter().flatten() {
        below(format!(" = {choice}"), &Json::Null, equal(values, choice));
    }
    if schema.get("type") == Some(&Json::from("boolean")) {
        for choice in [true, false] {
            below(format!(" = {choice}"), &Json::Null, equal(values, &Json::from(choice)));
        }
    }
    // keys of the user's own, elements of a list
    if let Some(content) = schema.get("additionalProperties").filter(|content| content.is_object()) {
        let all = values.iter().filter_map(|value| value.as_table());
        below(".NAME".into(), content, all.flat_map(|table| &table.0).map(|entry| &entry.node.value).collect());
    }
    if let Some(content) = schema.get("items") {
        let elements = values.iter().flat_map(|value| match value {
            Value::Array(elements) => &elements[..],
            _ => &[],
        });
        below("[]".into(), content, elements.map(|element| &element.value).collect());
    }
}

/// The values that are this choice.
fn equal<'v>(values: &[&'v Value], choice: &Json) -> Vec<&'v Value> {
    let is = |value: &Value| match value {
        Value::String(text) => *choice == text[..],
        Value::Boolean(value) => *choice == *value,
        _ => false,
    };
    values.iter().copied().filter(|value| is(value)).collect()
}
