# Only sources can be fixed.
args fix app.c

-- stderr --
smc: 'app.c' is not a source: names of sources end in .sm, .sv, .ss, .io or .app
Try 'smc fix --help'.
-- exit --
2
