# Messages want their state vector, and give C.
args build a.net --emit=c
args build a.net --sv v.sv
args check a.net
args check a.net --sv v.sv
args build a.net --emit=ast
args build a.net --emit=tokens

-- v.sv --
[Valves]
bool open
-- a.net --
endpoint ground 10.0.0.2:5000
receive a on ground @timeout 10 ms { [Valves] @hold }
-- stdout --
# Syntax tree of a.net, printed by smc
endpoint ground 10.0.0.2:5000
receive a on udp ground @timeout 10 ms
  [Valves] @hold
# Tokens of a.net, printed by smc
1:1	name	endpoint
1:10	name	ground
1:17	address	10.0.0.2:5000
2:1	name	receive
2:9	name	a
2:11	name	on
2:14	name	ground
2:21	annotation	@timeout
2:30	number	10
2:33	name	ms
2:36	{	{
2:38	header	[Valves]
2:47	annotation	@hold
2:53	}	}
3:1	end	
-- stderr --
smc: pins and messages are built with their state vector, as in 'smc build a.net --sv app.sv --emit=c'
Try 'smc build --help'.
smc: pins and messages alone can only become C; add --emit=c
Try 'smc build --help'.
smc: pins and messages are checked with their state vector, as in 'smc check a.net --sv app.sv'
Try 'smc check --help'.
-- exit --
2 2 2 0 0 0
