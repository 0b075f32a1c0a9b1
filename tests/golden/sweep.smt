# smc sweep: where asserts and requirements begin to fail, with the margins of the current setting; a map of two parameters; every format.
args sweep v.sm v.ss v.rq --set limit=700:900:11
args sweep v.sm v.ss v.rq --set limit=700:900:21 --set wait=0:400:5
args sweep v.sm v.ss --set limit=700:900:3 --set=wait=10 --format=csv
args sweep v.sm v.ss v.rq --set limit=700:900:3 -o s.json -MD; cat s.json s.d
args sweep v.sm v.ss v.rq --set limit=700:900:3 -o s.svg; "$SMC" sweep v.sm v.ss v.rq --set limit=700:900:3 -o s.svg; cat s.svg
args sweep v.sm v.ss --set limit=800:900:2 | tail -n 1
args sweep v.sm v.ss --set on=false:true:5
args sweep v.sm v.ss --set on=0:1:2 --format=csv
args sweep v.sm v.ss v.rq --set limit=750:850:3 --set wait=50:60:2 --format=json
args sweep v.sm v.ss v.rq --set limit=750:850:3 --set wait=50:60:2 --format=csv
args sweep v.sm never.ss --set wait=0:3:20
args sweep v.sm v.ss
args sweep v.sm v.ss --set limt=700:900:3
args sweep v.sm v.ss --set limit=1:800:3
args sweep v.sm v.ss --set limit=800:700:3
args sweep v.sm v.ss --set limit=700:700:3
args sweep v.sm v.ss --set limit=700:800:1
args sweep v.sm v.ss --set limit=700:800:0
args sweep v.sm v.ss --set limit=700:800
args sweep v.sm v.ss --set limit=700:high:3
args sweep v.sm v.ss --set other=1:2:3
args sweep v.sm v.ss --set limit=700:800:3 --set limit=700:800:3
args sweep v.sm v.ss --set limit=700:800:200 --set wait=0:400:200
args sweep v.sm v.ss --set limit=700:800:3 --set wait=0:4:2 --set on=false:true:2

-- v.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only @range 0 1000
bool open
[local]
F64 limit = 775 @parameter @range 500 1000
U32 wait = 50 @parameter @range 0 500
bool on = true @parameter
[Fill]
.step
    open = p > limit and on
    p > 825 and T > wait: -> Abort
[Abort] @abort @safe
.entry
    open = true
-- v.ss --
[all_states]
true: p = G
at 760: @assert not open
at 820: @assert open
at 900: @assert state Abort
at 2 s: @stop
-- never.ss --
[all_states]
true: p = 1
at 1 s: @stop
-- v.rq --
R1 "open above 800" always p > 800 implies open
-- stdout --
sweep of v: 1 script, 45 runs
limit:
  700 to 740: fails: v.ss:3
  760 to 800: passes
  820 to 900: fails: R1, v.ss:4
  R1: passes up to 809.99, fails from 810
  v.ss:3: passes from 760, fails up to 759.99
  v.ss:4: passes up to 819.99, fails from 820
  now 775: below, fails at 759.99 (15.01 away, only the assert v.ss:3); above, fails at 810 (35 away, requirement R1)
sweep of v: 1 script, 163 runs
wait:
  no script or requirement notices any of these values, so none of them tests this parameter
  0 to 400: passes
  now 50: below, nothing notices it down to 0; above, nothing notices it up to 400
limit:
  700 to 750: fails: v.ss:3
  760 to 800: passes
  810: fails: R1
  820 to 900: fails: R1, v.ss:4
  R1: passes up to 809.99, fails from 810
  v.ss:3: passes from 760, fails up to 759.99
  v.ss:4: passes up to 819.99, fails from 820
  now 775: below, fails at 759.99 (15.01 away, only the assert v.ss:3); above, fails at 810 (35 away, requirement R1)
map: wait up, limit to the right from 700 to 900; '.' passes, a digit is the number of checks that fail, '+' more than 9
  400  111111.....1222222222
  300  111111.....1222222222
  200  111111.....1222222222
  100  111111.....1222222222
    0  111111.....1222222222
limit,now,failing,requirements,checks
700,,1,0,"v.ss:3"
775,now,0,0,""
800,,0,0,""
900,,1,0,"v.ss:4"
{"smc-sweep":1,"machine":"v","runs":36,"complete":true,"parameters":[
{"name":"limit","now":775,"is_swept":true,"is_noticed":true,"fails_now":false,"fails_below":759.99,"check_below":"v.ss:3","kind_below":"assert","fails_above":810,"check_above":"R1","kind_above":"requirement","values":[{"from":700,"to":700,"fails":["v.ss:3"]},{"from":775,"to":800,"fails":[]},{"from":900,"to":900,"fails":["R1","v.ss:4"]}]}],
"points":[
{"at":[700],"fails":["v.ss:3"]},
{"at":[775],"fails":[]},
{"at":[800],"fails":[]},
{"at":[900],"fails":["R1","v.ss:4"]}
],"boundaries":[
{"parameter":"limit","check":"R1","passes":809.9,"fails":810},
{"parameter":"limit","check":"v.ss:3","passes":760,"fails":759.99},
{"parameter":"limit","check":"v.ss:4","passes":819.9,"fails":820}
]}
s.json: v.sm v.ss v.rq
<svg xmlns="http://www.w3.org/2000/svg" class="smc-sweep" viewBox="0 0 680 130" width="680" height="130" font-family="sans-serif" font-size="11">
<rect width="100%" height="100%" fill="#fff"/>
<text x="142.00" y="42.00" text-anchor="end" fill="#222">R1</text>
<rect x="150.00" y="32.00" width="274.88" height="14.00" fill="#cfe8cf"/>
<rect x="424.88" y="32.00" width="225.12" height="14.00" fill="#b03030"/>
<text x="142.00" y="60.00" text-anchor="end" fill="#222">v.ss:3</text>
<rect x="150.00" y="50.00" width="149.99" height="14.00" fill="#b03030"/>
<rect x="299.99" y="50.00" width="350.01" height="14.00" fill="#cfe8cf"/>
<text x="142.00" y="78.00" text-anchor="end" fill="#222">v.ss:4</text>
<rect x="150.00" y="68.00" width="299.88" height="14.00" fill="#cfe8cf"/>
<rect x="449.88" y="68.00" width="200.12" height="14.00" fill="#b03030"/>
<line x1="337.50" x2="337.50" y1="30.00" y2="84.00" stroke="#222" stroke-dasharray="4 3"/>
<text x="337.50" y="26.00" text-anchor="middle" fill="#222">now</text>
<text x="150.00" y="98.00" text-anchor="start" fill="#222">700</text>
<text x="650.00" y="98.00" text-anchor="end" fill="#222">900</text>
<text x="400.00" y="114.00" text-anchor="middle" fill="#222">limit</text>
</svg>
  now 775: outside what was swept
sweep of v: 1 script, 2 runs
on:
  false: fails: v.ss:4
  true: passes
  v.ss:4: passes at true, fails at false
  now true: fails at false (only the assert v.ss:4)
on,now,failing,requirements,checks
false,,1,0,"v.ss:4"
true,now,0,0,""
{"smc-sweep":1,"machine":"v","runs":50,"complete":true,"parameters":[
{"name":"wait","now":50,"is_swept":true,"is_noticed":false,"fails_now":false,"values":[{"from":50,"to":60,"fails":[]}]},
{"name":"limit","now":775,"is_swept":true,"is_noticed":true,"fails_now":false,"fails_below":759.99,"check_below":"v.ss:3","kind_below":"assert","fails_above":810,"check_above":"R1","kind_above":"requirement","values":[{"from":750,"to":750,"fails":["v.ss:3"]},{"from":775,"to":800,"fails":[]},{"from":850,"to":850,"fails":["R1","v.ss:4"]}]}],
"points":[
{"at":[50,750],"fails":["v.ss:3"]},
{"at":[60,750],"fails":["v.ss:3"]},
{"at":[50,800],"fails":[]},
{"at":[60,800],"fails":[]},
{"at":[50,850],"fails":["R1","v.ss:4"]},
{"at":[60,850],"fails":["R1","v.ss:4"]}
],"boundaries":[
{"parameter":"limit","check":"R1","passes":809.99,"fails":810},
{"parameter":"limit","check":"v.ss:3","passes":760,"fails":759.99},
{"parameter":"limit","check":"v.ss:4","passes":819.99,"fails":820}
]}
wait,limit,now,failing,requirements,checks
50,750,,1,0,"v.ss:3"
60,750,,1,0,"v.ss:3"
50,800,,0,0,""
60,800,,0,0,""
50,850,,2,1,"R1, v.ss:4"
60,850,,2,1,"R1, v.ss:4"
sweep of v: 1 script, 4 runs
wait:
  no script or requirement notices any of these values, so none of them tests this parameter
  0 to 3: passes
  now 50: outside what was swept
-- stderr --
smc: sweep requires one or two parameters to sweep, as in --set=limit=700:900:21
Try 'smc sweep --help'.
smc: the machine has no parameter 'limt'; did you mean 'limit'?
smc: cannot set parameter 'limit' to 1: the value is below the range
smc: the first end of a sweep must be below the second one, not 'limit=800:700:3'
Try 'smc sweep --help'.
smc: the first end of a sweep must be below the second one, not 'limit=700:700:3'
Try 'smc sweep --help'.
smc: a sweep is NAME=LO:HI:N, as in --set=limit=700:900:21, with N from 2 to 10000; not 'limit=700:800:1'
Try 'smc sweep --help'.
smc: a sweep is NAME=LO:HI:N, as in --set=limit=700:900:21, with N from 2 to 10000; not 'limit=700:800:0'
Try 'smc sweep --help'.
smc: a sweep is NAME=LO:HI:N, as in --set=limit=700:900:21, with N from 2 to 10000; not 'limit=700:800'
Try 'smc sweep --help'.
smc: cannot set parameter 'limit' to high: the value is not a number
smc: cannot set parameter 'other' to 1: the machine has no such parameter
smc: the parameter 'limit' is swept twice: sweep another one, or one alone
Try 'smc sweep --help'.
smc: the map has too many points: at most 10000 are possible
Try 'smc sweep --help'.
smc: sweep requires one or two parameters to sweep, as in --set=limit=700:900:21
Try 'smc sweep --help'.
-- exit --
0 0 0 0 0 0 0 0 0 0 0 2 1 1 2 2 2 2 2 1 1 2 2 2
