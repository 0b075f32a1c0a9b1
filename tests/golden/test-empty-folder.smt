# A folder without cases.
args test sub

-- sub/readme --
-- stdout --
0 passed, 1 failed
-- stderr --
smc: there is no .smt case in 'sub'
-- exit --
1
