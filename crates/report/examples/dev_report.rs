//! temporary
fn main() {
    let dir = std::env::args().nth(1).unwrap();
    println!("{}", netcast_report::write_report(dir.as_ref()).unwrap().display());
}
