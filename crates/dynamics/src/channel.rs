//! The channels of the energy balance: where energy can be, and where it can go.

use std::ops::{AddAssign, Index, IndexMut};

use serde::{Deserialize, Serialize};

/// Declares [`Channel`]: a line a channel, in the order in which results list them.
macro_rules! channels {
    ($($(#[$doc:meta])* $variant:ident $name:literal $kind:ident,)*) => {
        /// A place where energy can be, or a way in which it can be lost.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Channel {
            $($(#[$doc])* $variant,)*
        }

        impl Channel {
            /// Every channel.
            pub const ALL: &'static [Channel] = &[$(Channel::$variant,)*];
            /// How many there are.
            pub const COUNT: usize = Channel::ALL.len();

            /// Its name in results.
            pub fn name(self) -> &'static str {
                match self { $(Channel::$variant => $name,)* }
            }

            fn kind(self) -> Kind {
                match self { $(Channel::$variant => Kind::$kind,)* }
            }
        }
    };
}

/// Kind of energy in a channel.
#[derive(PartialEq, Eq)]
enum Kind {
    /// Stored, from zero on.
    Stored,
    /// Stored, relative to a level that one may choose.
    Potential,
    /// Lost since the start, or given to something outside the net.
    Lost,
}

channels! {
    /// Kinetic energy of everything.
    Kinetic "kinetic" Stored,
    /// Elastic energy of segments, bent ropes and sheets.
    Elastic "elastic" Stored,
    /// Potential energy of weight, relative to the origin.
    Gravity "gravity" Potential,
    /// Potential energy of loads that act from the start, relative to the origin, less the work of the others.
    Load "load" Potential,
    /// Lost to damping inside ropes since the start.
    RopeDamping "rope_damping" Lost,
    /// Lost to damping inside sheets since the start.
    SheetDamping "sheet_damping" Lost,
    /// Lost to hysteresis of ropes since the start.
    RopeHysteresis "rope_hysteresis" Lost,
    /// Elastic energy of the segments that broke since the start, and of the bends over them, as they broke.
    Rupture "rupture" Lost,
    /// Lost to mass-proportional damping since the start.
    MassDamping "mass_damping" Lost,
    /// Work done on what moves driven nodes since the start; negative where this has moved the net.
    Drive "drive" Lost,
    /// Work done on launchers since the start; negative where these have thrown.
    Launch "launch" Lost,
    /// Work done on the air since the start; negative where wind has driven the net.
    Air "air" Lost,
    /// Work done on the inertia of the medium around ropes since the start.
    AddedMass "added_mass" Lost,
    /// Elastic energy of the ground.
    Ground "ground" Stored,
    /// Lost to the ground since the start.
    GroundFriction "ground_friction" Lost,
    /// Potential energy beside an orbit, relative to the origin.
    Orbit "orbit" Potential,
    /// Work done on effects of the caller's own, less what these have stored. Results list it only where there are some.
    Custom "custom" Lost,
}

impl Channel {
    /// Whether it holds energy that is stored, kinetic or potential.
    pub fn is_stored(self) -> bool {
        self.kind() != Kind::Lost
    }

    /// Whether its zero is a level that one may choose.
    pub fn is_potential(self) -> bool {
        self.kind() == Kind::Potential
    }
}

/// An energy a channel, J.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ByChannel([f64; Channel::COUNT]);

impl ByChannel {
    /// The sum over all channels, J.
    pub fn sum(&self) -> f64 {
        self.0.iter().sum()
    }
}

impl AddAssign for ByChannel {
    fn add_assign(&mut self, other: ByChannel) {
        for (own, other) in self.0.iter_mut().zip(other.0) {
            *own += other;
        }
    }
}

impl Index<Channel> for ByChannel {
    type Output = f64;

    fn index(&self, channel: Channel) -> &f64 {
        &self.0[channel as usize]
    }
}

impl IndexMut<Channel> for ByChannel {
    fn index_mut(&mut self, channel: Channel) -> &mut f64 {
        &mut self.0[channel as usize]
    }
}
