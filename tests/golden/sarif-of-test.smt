# What reports more than once cannot be one document.
args test --message-format=sarif a.sm a.ss

-- stderr --
smc: --message-format=sarif is for check and build only
Try 'smc test --help'.
-- exit --
2
