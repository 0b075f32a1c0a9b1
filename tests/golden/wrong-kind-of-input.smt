# An input that is no source.
args build a.txt

-- a.txt --
hello
-- stderr --
smc: 'a.txt' is not a source: names of sources end in .sm, .sv, .ss, .io or .app
Try 'smc build --help'.
-- exit --
2
