# Of several names those that are known are explained.
args explain E0109 W9999

-- stdout --
E0109: a statement ends at the end of its line, without ';'
...
-- stderr --
smc: no diagnostic is called 'W9999'[..]
Try 'smc explain --help'.
-- exit --
2
