//! What an error is about: a key that a program finds its place by, apart from the words that a person reads.

/// An enum of fields, each with what a message calls it; `ALL` lists them.
macro_rules! fields {
    ($(#[$of:meta])* $name:ident { $($(#[$doc:meta])* $field:ident => $words:literal,)+ }) => {
        $(#[$of])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name {
            $($(#[$doc])* $field,)+
        }

        impl $name {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$field),+];
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.write_str(match self {
                    $(Self::$field => $words,)+
                })
            }
        }
    };
}

fields! {
    /// A number that a web is drawn by.
    WebField {
        /// Side of the web.
        Side => "the web's side",
        /// Diameter of the web.
        Diameter => "the web's diameter",
        /// Diameter of the hub.
        HubDiameter => "the hub's diameter",
        /// Side of a mesh.
        Mesh => "the mesh",
        /// Number of sides of a polygon.
        Sides => "the number of sides",
        /// Number of radials.
        Radials => "the number of radials",
        /// Number of rings.
        Rings => "the number of rings",
        /// Number of corners.
        Corners => "the number of corners",
        /// Meshes across the width.
        MeshesWide => "the number of meshes across the width",
        /// Meshes across the height.
        MeshesHigh => "the number of meshes across the height",
        /// Meshes along a side, which follow from the mesh.
        MeshesAlongSide => "the number of meshes along a side",
        /// Meshes from the middle of a polygon to a side, which follow from the mesh.
        MeshesToSide => "the number of meshes from the middle to a side",
        /// Cells along a side.
        CellsPerSide => "the number of cells along a side",
        /// Width of a mesh over its stretched width.
        HangingRatio => "the hanging ratio",
        /// From one tie of a gathering rope to the next.
        GatheringEvery => "the knots from tie to tie of a gathering rope",
        /// Excess length of a gathering rope.
        GatheringExcess => "the excess of a gathering rope",
        /// Side of a canopy.
        CanopySide => "the canopies' side",
        /// Side of a hexagon of rope.
        HexagonSide => "the rope hexagons' side",
        /// Side of a sheet.
        SheetSide => "a sheet's side",
        /// Edges along a side of a sheet.
        Fineness => "a sheet's fineness",
        /// Length of the traction ropes.
        TractionLength => "the traction ropes' length",
        /// Number of parallel traction ropes.
        TractionCount => "the number of parallel traction ropes",
    }
}

fields! {
    /// What a packing is described by.
    PackingField {
        /// Share that the web is shrunk to.
        Factor => "factor",
        /// Radius of the pack.
        Radius => "radius",
        /// How deep it is.
        Depth => "depth",
        /// Radius of the circle on which the tractors stand.
        TractorRadius => "tractors' radius",
        /// How far the tractors stand above the web.
        TractorGap => "tractor gap",
        /// The room that it is packed into.
        Container => "container",
        /// Positions of the nodes.
        Positions => "positions",
        /// What is led into a container.
        Paths => "paths",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_is_listed_with_words_of_its_own() {
        let mut words: Vec<String> = WebField::ALL.iter().map(ToString::to_string).collect();
        words.extend(PackingField::ALL.iter().map(ToString::to_string));
        let count = words.len();
        words.sort();
        words.dedup();
        assert_eq!(words.len(), count);
    }
}
