# What reports more than once cannot be one document.
args test --message-format=sarif a.sm a.ss

-- stderr --
smc: --message-format=sarif requires --message-file=FILE here: standard error also has the failures of cases, as text
Try 'smc test --help'.
-- exit --
2
