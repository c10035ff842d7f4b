//! The moving box: the worked example, and what steps miss.

use super::percent;
use crate::reproduce::nathan::definition::Sweep;
use crate::reproduce::nathan::records::Records;
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::Sheet;
use anyhow::Result;

const PICTURE: &str = "\
```text
                         .-------.
                  , - '  '  end  |
           , - '         |       |
   .-------.             '-------'
   | start |       , - o'            o  an obstacle near the edge of the way,
   |       | , - '                      between two stops of the box
   '-------'
```
";

/// Writes `sweep.md` and `sweep.csv`.
pub(crate) fn write(folder: &Folder, block: &Sweep, records: &Records) -> Result<()> {
    let mut text = format!(
        "A box with sides {:?}, a corner at the origin, moves by {:?}. The volume that it sweeps is the hull of its 16 \
         corners at the start and at the end, certified.\n\n{PICTURE}\n",
        block.sides, block.by
    );
    for row in records
        .own
        .sweep
        .iter()
        .filter(|row| row.obstacle == "example")
    {
        let found = if row.missed == 0 { "found" } else { "missed" };
        text += &match row.steps {
            None => format!(
                "The obstacle at {:?} is {found} by the one check against the hull, exactly.\n\n",
                block.obstacle
            ),
            Some(steps) => format!("- by {steps} steps it is {found}\n"),
        };
    }
    let mut sheet = Sheet::new(&["check", "obstacles met in truth", "missed", "missed, %"]);
    for row in records
        .own
        .sweep
        .iter()
        .filter(|row| row.obstacle == "random")
    {
        sheet.push(vec![
            row.steps
                .map_or("hull".to_owned(), |steps| format!("{steps} steps")),
            row.obstacles.to_string(),
            row.missed.to_string(),
            percent(row.missed, row.obstacles),
        ]);
    }
    text += &format!(
        "\nRandom point obstacles, each a point of the box carried a random share of the way:\n\n{}\nThe same for any part \
         and any move: `hullbench sweep part.off --by 10,5,0 --obstacle 5.4321,2.2185,0.5`.\n",
        sheet.markdown()
    );
    folder.markdown("sweep.md", "The swept volume of a moving box", &text)?;
    folder.csv("sweep.csv", &sheet.csv())
}
