# Only sources can be fixed.
args fix app.c

-- stderr --
smc: 'app.c' is no source: names end in .sm, .sv, .ss or .io
Try 'smc fix --help'.
-- exit --
2
