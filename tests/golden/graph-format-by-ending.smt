# Without --format the name behind -o says what the diagram is written for; --format is stronger; an ending that says nothing is a picture.
args graph tank.sm -o tank.dot && head -n 1 tank.dot
args graph tank.sm -o tank.gv && head -n 1 tank.gv
args graph tank.sm -o tank.mmd && head -n 1 tank.mmd
args graph tank.sm -o tank.mermaid && head -n 1 tank.mermaid
args graph tank.sm -o tank.svg && head -c 4 tank.svg
args graph tank.sm -o tank.dot --format=mermaid && head -n 1 tank.dot
args graph tank.sm -o dot && head -c 4 dot

-- tank.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stdout --
digraph "tank" { // drawn by smc
digraph "tank" { // drawn by smc
stateDiagram-v2
stateDiagram-v2
<svgstateDiagram-v2
<svg
