//! The library of materials: every value has a source and agrees with physics and other sources. A scenario takes the
//! values that it does not state, and docs/materials.md shows all values.

mod common;

use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_4;

use common::parse;
use netcast_scenario::library::{Fibre, Per, RopeMaterial, Value, library};
use netcast_scenario::quantity::Quantity;
use netcast_scenario::{Canopy, Diagnostics, resolved_toml};

/// A value without its type: its name, its sources with those of its scatter, and whether it lies within its scatter.
struct Checked {
    what: String,
    sources: Vec<String>,
    lies_in_its_scatter: bool,
}

fn checked<U, I>(what: &str, value: &Value<Quantity<U, I>>) -> Checked {
    let mut sources = value.sources.clone();
    assert!(!sources.is_empty(), "{what} has no source");
    let mut lies_in_its_scatter = true;
    if let Some(scatter) = &value.scatter {
        assert!(!scatter.sources.is_empty(), "the scatter of {what} has no source");
        sources.extend(scatter.sources.clone());
        let (from, value, to) = (scatter.from.si(), value.value.si(), scatter.to.si());
        lies_in_its_scatter = from < to && from <= value && value <= to;
    }
    Checked { what: what.to_owned(), sources, lies_in_its_scatter }
}

fn of_fibre(name: &str, fibre: &Fibre) -> Vec<Checked> {
    vec![
        checked(&format!("the density of {name}"), &fibre.density),
        checked(&format!("the modulus of {name}"), &fibre.modulus_n_tex),
        checked(&format!("the tenacity of {name}"), &fibre.tenacity_n_tex),
        checked(&format!("the elongation of {name}"), &fibre.elongation_at_break),
    ]
}

fn of_rope(name: &str, rope: &RopeMaterial) -> Vec<Checked> {
    let mut all = vec![
        checked(&format!("the density of {name}"), &rope.density),
        checked(&format!("the strength of {name}"), &rope.strength),
    ];
    all.extend(rope.elastic_modulus.as_ref().map(|e| checked(&format!("the modulus of {name}"), e)));
    all.extend(rope.stiffness.as_ref().map(|k| checked(&format!("the stiffness of {name}"), k)));
    all
}

#[test]
fn every_value_has_a_source_and_lies_in_its_scatter() {
    let library = library();
    let fibres = library.fibres.iter().flat_map(|(name, fibre)| of_fibre(name, fibre));
    let ropes = library.ropes.iter().flat_map(|(name, rope)| of_rope(name, rope));
    let mut used = BTreeSet::new();
    for Checked { what, sources, lies_in_its_scatter } in fibres.chain(ropes) {
        assert!(lies_in_its_scatter, "{what} lies outside its scatter");
        for source in sources {
            assert!(library.sources.contains_key(&source), "{what}: no source is called {source}");
            used.insert(source);
        }
    }
    assert_eq!(used, library.sources.keys().cloned().collect(), "sources that nothing is from");
    let of_ropes = library.ropes.values().map(|rope| &rope.fibre);
    for fibre in of_ropes.chain(library.cloths.values().map(|cloth| &cloth.fibre)) {
        assert!(library.fibres.contains_key(fibre), "no fibre is called {fibre}");
    }
}

/// A rope has air between its fibres, and its fibres do not lie along it.
#[test]
fn no_rope_is_denser_stiffer_or_stronger_than_its_fibre() {
    for (name, rope) in &library().ropes {
        let fibre = &library().fibres[&rope.fibre];
        let solid = rope.nominal_density() / fibre.density.value.si();
        assert!((0.4..0.91).contains(&solid), "{name}: {solid} of it is solid");
        assert!(rope.elastic_modulus.is_some() != rope.stiffness.is_some(), "{name}");
        let stiffness = rope.nominal_elastic_modulus() / fibre.elastic_modulus();
        assert!((0.1..0.9).contains(&stiffness), "{name} is {stiffness} as stiff as its fibre");
        let strength = rope.stress_at_break() / fibre.strength();
        assert!((0.2..0.7).contains(&strength), "{name} is {strength} as strong as its fibre");
        // the linear law up to the breaking load, against what the yarn bears
        let strain = rope.stress_at_break() / rope.nominal_elastic_modulus();
        let limit = fibre.elongation_at_break.value.si();
        assert!(strain <= 1.01 * limit, "{name} breaks at a strain of {strain}, its yarn at {limit}");
    }
}

#[test]
fn fibres_have_plausible_density_modulus_and_strength() {
    for (name, fibre) in &library().fibres {
        assert!((900.0..8000.0).contains(&fibre.density.value.si()), "{name}");
        assert!((3e9..250e9).contains(&fibre.elastic_modulus()), "{name}: {} Pa", fibre.elastic_modulus());
        assert!((0.8e9..4.2e9).contains(&fibre.strength()), "{name}: {} Pa", fibre.strength());
        // no yarn is stretched beyond its break by a load below its strength
        let chord = fibre.strength() / fibre.elongation_at_break.value.si();
        assert!((0.3..2.0).contains(&(chord / fibre.elastic_modulus())), "{name}: {chord} Pa");
    }
    // Kim and Mai (1998), table 5.10, for Kevlar 29 and 49; Teijin's own GPa for LCP, 7600 kg/mm^2
    for (fibre, published) in [("aramid", 83e9), ("aramid, high modulus", 135e9), ("LCP", 7600e6 * 9.80665)] {
        let modulus = library().fibres[fibre].elastic_modulus();
        assert!((0.75..1.01).contains(&(modulus / published)), "{fibre}: {modulus} Pa, elsewhere {published} Pa");
    }
}

/// Axial stiffness as the source itself computes it, over d^2, Pa.
#[test]
fn axial_stiffness_agrees_with_the_value_of_its_source() {
    let published =
        [("nylon rope", 1.04e9), ("polyester rope", 4.32e9), ("UHMWPE rope", 32.5e9), ("LCP rope", 33.73e9)];
    for (name, published) in published {
        let found = FRAC_PI_4 * library().ropes[name].nominal_elastic_modulus();
        assert!((found / published - 1.0).abs() < 0.01, "{name}: {found} Pa, published {published} Pa");
    }
}

/// Ropes as thin as those of nets, from tables of makers that the values are not fitted to.
#[test]
fn thin_ropes_in_tables_of_makers_lie_within_the_scatter() {
    let (inch, lb, lbf, ft) = (0.0254, 0.453_592_37, 4.448_221_6, 0.3048);
    // Industrial Rope, three-strand nylon: inch, lb a 100 ft, lbf
    let laid_nylon = [(0.25, 1.5, 1490.0), (0.3125, 2.5, 2300.0), (0.375, 3.5, 3340.0), (0.5, 6.5, 5750.0)]
        .map(|(d, mass, load)| (d * inch, mass * lb / (100.0 * ft), load * lbf));
    // Robline Rapallo: mm, g/m, daN
    let yacht_polyester =
        [(6.0, 24.0, 750.0), (8.0, 43.0, 1200.0), (10.0, 68.0, 1950.0), (12.0, 94.0, 2700.0), (20.0, 244.0, 7000.0)]
            .map(|(d, mass, load)| (1e-3 * d, 1e-3 * mass, 10.0 * load));
    let tables = [("nylon rope", &laid_nylon[..]), ("polyester rope", &yacht_polyester[..])];
    for (name, diameter, mass, load) in
        tables.into_iter().flat_map(|(name, rows)| rows.iter().map(move |&(d, mass, load)| (name, d, mass, load)))
    {
        let rope = &library().ropes[name];
        let predicted = rope.nominal_density() * FRAC_PI_4 * diameter * diameter;
        assert!((mass / predicted - 1.0).abs() < 0.11, "{name} of {diameter} m: {mass} kg/m, not {predicted}");
        let scatter = rope.strength.scatter.as_ref().unwrap();
        let per_square = load / (diameter * diameter);
        assert!((scatter.from.si()..=scatter.to.si()).contains(&per_square), "{name} of {diameter} m: {per_square} Pa");
        assert!(load < rope.breaking_load(diameter), "{name}");
    }
}

const NET: &str = "\
[web.square]
side = 2
mesh = 0.5
[rope]
diameter = \"4 mm\"
material = \"nylon rope\"
[solve]
duration = 0.1
";

#[test]
fn a_scenario_takes_values_from_the_library_that_it_does_not_state() {
    let document = parse(NET, &[]).unwrap();
    let rope = &document.scenario.rope;
    // 585 kg/m^3, 207 MPa and five times that, of the square of the diameter, to three digits
    assert_eq!((rope.density.si(), rope.elastic_modulus.si()), (745.0, 1.32e9));
    assert_eq!(rope.strength.unwrap().si(), 3310.0);
    let keys: Vec<&str> = document.library.taken.iter().map(|one| one.key).collect();
    assert_eq!(keys, ["density", "elastic_modulus", "strength"]);

    let text = format!("{NET}[ropes.thin]\nmaterial = \"nylon rope\"\ndiameter = 0.002\nstrength = \"500 N\"\n");
    let thin = parse(&text, &["rope.elastic_modulus=2 GPa"]).unwrap().scenario;
    assert_eq!(thin.ropes["thin"].strength.unwrap().si(), 500.0);
    assert_eq!(thin.ropes["thin"].elastic_modulus.si(), 1.32e9);
    assert_eq!((thin.rope.elastic_modulus.si(), thin.rope.strength.unwrap().si()), (2e9, 3310.0));
    // the strength of the library suffices for a reduction by knots
    assert!(parse(NET, &["rope.knot_reduction=30 %"]).is_ok());
}

#[test]
fn a_resolved_scenario_does_not_need_the_library() {
    let document = parse(NET, &[]).unwrap();
    let resolved = resolved_toml(&document.scenario);
    assert!(!resolved.contains("material"), "{resolved}");
    let annotated = document.library.comments() + &resolved;
    assert!(annotated.contains("# [rope] nylon rope: elastic_modulus = 1.32 GPa (nrel)\n"), "{annotated}");
    let again = parse(&annotated, &[]).unwrap();
    assert_eq!(again.scenario, document.scenario);
    assert_eq!(again.library.comments(), "");
}

#[test]
fn a_cloth_has_half_the_modulus_of_its_fibre() {
    let text = NET.replace("[web.square]\nside = 2\nmesh = 0.5", "[web.space]\nside = 2")
        + "[canopy.links]\nmaterial = \"aramid cloth\"\nthickness = \"0.12 mm\"\n";
    let scenario = parse(&text, &[]).unwrap().scenario;
    let Some(Canopy::Links(links)) = &scenario.canopy else { panic!() };
    // Teijin's table: 500 cN/dtex at 1.44 g/cm^3
    assert_eq!((links.density.si(), links.elastic_modulus.si()), (1440.0, 0.5 * 50e6 * 1440.0));
    assert_eq!((links.side.si(), links.thickness.si()), (0.14, 0.12e-3));
    assert!(!resolved_toml(&scenario).contains("material"));
}

fn wrong(text: &str, overrides: &[&str]) -> Vec<String> {
    let Diagnostics(found) = parse(text, overrides).unwrap_err();
    found.iter().map(ToString::to_string).collect()
}

#[test]
fn an_unknown_material_is_reported_with_the_known_materials() {
    let found = wrong(&NET.replace("nylon rope", "nylon rop"), &[]);
    let names: Vec<String> = library().ropes.keys().map(|name| format!("{name:?}")).collect();
    let expected = format!(
        "net.toml:6:12: rope.material: expected {}, found the string \"nylon rop\" (did you mean \"nylon rope\"?)",
        names.join(" or ")
    );
    assert_eq!(found, [expected]);
    // the name of a cloth is not accepted for a rope
    assert!(wrong(NET, &["rope.material=aramid cloth"])[0].contains("expected \"LCP rope\" or"));
    // without a material the values are required
    let found = wrong(&NET.replace("material = \"nylon rope\"\n", ""), &[]);
    assert_eq!(found.len(), 2, "{found:#?}");
    assert!(found[0].contains("missing key `density`") && found[1].contains("missing key `elastic_modulus`"));
    // a faulty diameter is reported once
    assert_eq!(wrong(NET, &["rope.diameter=-4 mm"]).len(), 1);
}

#[test]
fn a_material_without_effect_is_noted() {
    let notes = |overrides: &[&str]| parse(NET, overrides).unwrap().library.notes();
    let told = |notes: Vec<String>| notes.iter().any(|note| note.starts_with("rope.material changes nothing"));
    assert!(told(notes(&["rope.density=700", "rope.elastic_modulus=1 GPa", "rope.strength=1 kN"])));
    assert!(!told(notes(&["rope.density=700", "rope.elastic_modulus=1 GPa"])));
}

/// The tables of docs/materials.md.
fn tables() -> String {
    let library = library();
    let mut text = String::from(
        "| rope | density, kg/m³ | elastic modulus, GPa | breaking stress, MPa | breaking load of 3, 5, 10 mm, kN | fibre |\n\
         |---|---|---|---|---|---|\n",
    );
    for (name, rope) in &library.ropes {
        let loads = [3e-3, 5e-3, 10e-3].map(|d| short(1e-3 * rope.breaking_load(d))).join(", ");
        let (density, modulus) = (rope.nominal_density(), short(1e-9 * rope.nominal_elastic_modulus()));
        let stress = 1e-6 * rope.stress_at_break();
        text += &format!("| {name} | {density} | {modulus} | {stress:.0} | {loads} | {} |\n", rope.fibre);
    }
    text += "\n| rope | value | as its source gives it | scatter | sources | remark |\n|---|---|---|---|---|---|\n";
    for (name, rope) in &library.ropes {
        text += &row(name, "density", &rope.density, true);
        text += &rope.elastic_modulus.as_ref().map_or(String::new(), |e| row(name, "elastic modulus", e, true));
        text += &rope.stiffness.as_ref().map_or(String::new(), |k| row(name, "EA / breaking load", k, false));
        text += &row(name, "strength", &rope.strength, true);
    }
    text += "\n| cloth | density, kg/m³ | elastic modulus, GPa | fibre | what it is |\n|---|---|---|---|---|\n";
    for (name, cloth) in &library.cloths {
        let fibre = &library.fibres[&cloth.fibre];
        let (density, modulus) = (fibre.density.value.si(), short(1e-9 * cloth.elastic_modulus(fibre)));
        text += &format!("| {name} | {density} | {modulus} | {} | {} |\n", cloth.fibre, cloth.summary);
    }
    text += "\n| fibre | value | as its source gives it | scatter | sources | remark |\n|---|---|---|---|---|---|\n";
    for (name, fibre) in &library.fibres {
        text += &row(name, "density", &fibre.density, false);
        text += &row(name, "modulus, N/tex", &fibre.modulus_n_tex, false);
        text += &row(name, "tenacity, N/tex", &fibre.tenacity_n_tex, false);
        text += &row(name, "elongation at break", &fibre.elongation_at_break, false);
    }
    text += "\n| source | what it is |\n|---|---|\n";
    for (name, source) in &library.sources {
        text += &format!("| {name} | {source} |\n");
    }
    text
}

/// A number without the digits that rounding left.
fn short(value: f64) -> String {
    let digits = format!("{value:.3}");
    digits.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A value with its unit; stresses in MPa or GPa.
fn shown<U: netcast_scenario::dimension::Measured, I>(value: &Quantity<U, I>) -> String {
    match (U::KIND.unit, value.si()) {
        ("Pa", si) if si < 1e10 => format!("{} MPa", short(1e-6 * si)),
        ("Pa", si) => format!("{} GPa", short(1e-9 * si)),
        _ => value.to_string(),
    }
}

/// A row of a table: a value as in its source.
fn row<U: netcast_scenario::dimension::Measured, I>(
    of: &str,
    what: &str,
    value: &Value<Quantity<U, I>>,
    is_of_an_area: bool,
) -> String {
    let per = match value.per {
        _ if !is_of_an_area => "",
        Per::NominalSection => " of π d² / 4",
        Per::DiameterSquared => " of d²",
    };
    let scatter = value.scatter.as_ref().map_or("–".to_owned(), |scatter| {
        format!("{} to {} ({})", shown(&scatter.from), shown(&scatter.to), scatter.sources.join(", "))
    });
    let note = value.note.as_deref().unwrap_or("");
    format!("| {of} | {what} | {}{per} | {scatter} | {} | {note} |\n", shown(&value.value), value.sources.join(", "))
}

#[test]
fn the_documentation_shows_every_value_of_the_library() {
    let page = include_str!("../../../docs/materials.md");
    let tables = tables();
    let missing: Vec<&str> = tables.split("\n\n").filter(|table| !page.contains(table.trim_end())).collect();
    assert!(missing.is_empty(), "docs/materials.md should have\n\n{}", missing.join("\n\n"));
}
