# Without --format the name behind -o says how the report is written; --format is stronger; an ending that says nothing is a page.
args report tank.sm -o tank.html && head -n 1 tank.html
args report tank.sm -o tank.htm && head -n 1 tank.htm
args report tank.sm -o tank.txt && head -n 2 tank.txt
args report tank.sm -o tank.json && head -c 15 tank.json
args report tank.sm -o tank.txt --format=html && head -n 1 tank.txt
args report tank.sm -o tank && head -n 1 tank

-- tank.sm --
[state_vector]
U64 G
U32 S
[Idle]
-- stdout --
<!DOCTYPE html>
<!DOCTYPE html>
tank
====
{"smc-report": <!DOCTYPE html>
<!DOCTYPE html>
