//! A net built in code, thrown, and looked at: which speed opens it widest?
//!
//! A round net of 3 m with eight masses on its rim is thrown at three speeds. Each run stays in memory; its history gives
//! when it is open, its frames give where its lowest node is then. Run it with:
//!
//! ```text
//! cargo run --release -p netcast --example thrown_net
//! ```

use netcast::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("radial speed  largest area  at       lowest node then");
    for radial_speed_m_s in [6.0, 9.0, 12.0] {
        let run = net(radial_speed_m_s)?.simulate()?;
        if let Some(failure) = &run.failure {
            return Err(failure.to_string().into());
        }
        let opening = &run.summary.opening;
        let (Some(area_m2), Some(time_s)) = (opening.area_max_m2, opening.area_max_time_s) else {
            return Err("the net has no outline".into());
        };
        let lowest_m = run
            .frames()
            .min_by(|one, other| (one.time_s - time_s).abs().total_cmp(&(other.time_s - time_s).abs()))
            .map(|frame| frame.position_m.iter().map(|position| position.z).fold(f64::INFINITY, f64::min))
            .ok_or("the run has no frames")?;
        println!("{radial_speed_m_s:>8} m/s  {area_m2:>8.2} m^2  {time_s:.3} s  {lowest_m:.2} m");
    }
    Ok(())
}

/// A spider's web of 3 m in a bag, its eight masses thrown at 20 m/s along the axis and so fast away from it.
fn net(radial_speed_m_s: f64) -> Result<Case, Diagnostics> {
    Case::new(Web::radial("3 m", 8, 4))
        .title("A round net")
        .rope(Rope::new("2 mm", "970 kg/m^3", "5 GPa"))
        .tractor(Body::particle("0.1 kg"))
        .stow(Stow::bag("0.15 m"))
        .launch(Launch::new("20 m/s", radial_speed_m_s))
        .duration("0.4 s")
        .build()
}
