# Nothing near is known: nothing is offered.
args xylophone

-- stderr --
smc: unknown command 'xylophone'
Try 'smc --help'.
-- exit --
2
