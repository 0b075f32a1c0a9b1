# A name that ends as another program's files do would be written with what that program cannot read.
args graph tank.sm -o tank.png
args graph tank.sm -o tank.pdf
args report tank.sm -o tank.docx
args graph tank.sm -o tank.pdf --format=svg && head -c 4 tank.pdf

-- tank.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stdout --
<svg
-- stderr --
smc: 'tank.png': .png is not a format that smc writes here; use a name that ends in .svg, .dot or .mmd
Try 'smc graph --help'.
smc: 'tank.pdf': .pdf is not a format that smc writes here; use a name that ends in .svg, .dot or .mmd
Try 'smc graph --help'.
smc: 'tank.docx': .docx is not a format that smc writes here; use a name that ends in .html, .txt or .json
Try 'smc report --help'.
-- exit --
2 2 2 0
