# A label that is shortened says where conditions around it are left out.
args graph -w --format=dot deep.sm | grep 'label="… and'

-- deep.sm --
[state_vector]
U64 G
U32 S
F32 chamber @read_only
F32 tank    @read_only
[Hold]
.step
    if chamber > 1 and tank > 17 {
        if roll_median(chamber, 9) > 10 {
            if T > 10000 {
                if roll_median(tank, 9) > 20: T > 30000: -> Go
                else if chamber > 30 {
                    if roll_avg(tank, 100) > 50: -> Go
                }
            }
        }
    }
[Go]
-- stdout --
    "Hold" -> "Go" [label="… and roll_median(chamber, 9) > 10\nand T > 10000 and roll_median(tank, 9) > 20\nand T > 30000\nor\n… and roll_median(tank, 9) > 20\nand not (T > 30000) and chamber > 30\nand roll_avg(tank, 100) > 50"];
