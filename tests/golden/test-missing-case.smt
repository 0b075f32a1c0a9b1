# A case that is not there.
args test nowhere.smt

-- stdout --
0 passed, 1 failed
-- stderr --
nowhere.smt: failed
    cannot read 'nowhere.smt': No such file or directory
-- exit --
3
