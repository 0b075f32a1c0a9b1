# A folder without cases.
args test sub

-- sub/readme --
-- stdout --
0 passed, 1 failed
-- stderr --
smc: no .smt case is in 'sub'
-- exit --
1
