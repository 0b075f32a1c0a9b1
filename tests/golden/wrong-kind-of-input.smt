# An input that is no source.
args build a.txt

-- a.txt --
hello
-- stderr --
smc: 'a.txt' is no source: names end in .sm, .sv, .ss or .io
Try 'smc build --help'.
-- exit --
2
