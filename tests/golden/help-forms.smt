# Help is found however it is asked for.
args check -h | head -n 1
args help check | head -n 1
args help chek
args explain '[W0750' 'unjudged-assert]' | head -n 1
args explain '[nothing]'

-- stdout --
Usage: smc check FILE...|X.app [SCRIPT.ss...]
Usage: smc check FILE...|X.app [SCRIPT.ss...]
W0750: this assert was never evaluated  [-Wunjudged-assert]
-- stderr --
smc: unknown command 'chek'; did you mean 'check'?
Try 'smc --help'.
smc: no diagnostic is called '[nothing]'
Try 'smc explain --help'.
-- exit --
0 0 2 0 2
