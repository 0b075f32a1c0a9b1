# The state diagram as SVG: a line, a stub, a loop, an @abort and a @safe state, one that is never reached.
args graph -w tank.sm

-- tank.sm --
[state_vector]
U64 G
U32 S
F64 pressure @read_only
bool armed   @read_only
bool valve
[Idle]
.step
    armed: -> Fill
[Fill]
.entry
    valve = true
.step
    pressure > 800 or pressure < 1: -> Abort
    T > 60000: -> Abort
    pressure > 500 and armed: -> Done
    pressure == 499: -> Fill
.exit
    valve = false
[Abort] @abort
.step
    1 > 2: -> Idle
[Done] @safe @swap
[Lost]
.entry
    -> Idle
-- stdout --
<svg xmlns="http://www.w3.org/2000/svg" class="smc-graph" role="img" stroke-width="1.4" width="648" height="422" viewBox="0 0 648 422">
<title>State diagram of tank</title>
<desc>5 states, 7 transitions. The initial state is Idle.</desc>
<style>
.smc-graph text{font-family:Helvetica,Arial,sans-serif;font-size:11px}
.smc-graph .g-name{font-size:13px;font-weight:bold;text-anchor:middle}
.smc-graph .g-all .g-name{font-style:italic}
.smc-graph .g-to{font-weight:bold;text-anchor:middle}
.smc-graph .g-mid{text-anchor:middle}
.smc-graph .g-end{text-anchor:end}
.smc-graph .g-block{font-style:italic}
.smc-graph .g-line{fill:none}
.smc-graph .g-box{stroke-width:1.4}
.smc-graph .g-abort,.smc-graph .g-safe{stroke-width:2.2}
.smc-graph .g-in{fill:none;stroke-width:1}
.smc-graph .g-rule{stroke-width:1}
.smc-graph .g-never .g-line,.smc-graph .g-never .g-box{stroke-dasharray:5 4}
.smc-graph .g-never text{font-style:italic}
.smc-graph .g-unrun .g-line,.smc-graph .g-unrun .g-box{stroke-dasharray:1 4;stroke-linecap:round}
.smc-graph .g-unrun text{font-weight:normal}
.smc-graph .g-edge:hover .g-line{stroke-width:3}
.smc-graph .g-bang{font-weight:bold;font-size:9px;text-anchor:middle}
.smc-graph .g-back{fill:#fff}
.smc-graph text{fill:#1c2430}
.smc-graph .g-guard{fill:#3a4656}
.smc-graph .g-line{stroke:#6a7787}
.smc-graph .g-head,.smc-graph .g-start{fill:#6a7787}
.smc-graph .g-state{fill:#eef3f9;stroke:#46566b}
.smc-graph .g-abort{fill:#fdeae4;stroke:#b5320f}
.smc-graph .g-safe{fill:#e3f3f1;stroke:#0c7268}
.smc-graph .g-rule{stroke:#c9d0d9}
.smc-graph .g-unrun .g-line,.smc-graph .g-unrun .g-box{stroke:#8a3ffc}
.smc-graph .g-mark{fill:#ffcf33;stroke:#5c4700}
.smc-graph .g-mark.g-error{fill:#d92d20;stroke:#7a130b}
.smc-graph .g-bang{fill:#3d2f00}
@media screen and (prefers-color-scheme:dark){
.smc-graph .g-back{fill:#15191f}
.smc-graph text{fill:#e3e8ef}
.smc-graph .g-guard{fill:#c3ccd8}
.smc-graph .g-line{stroke:#94a1b3}
.smc-graph .g-head,.smc-graph .g-start{fill:#94a1b3}
.smc-graph .g-state{fill:#222c3a;stroke:#9fb0c6}
.smc-graph .g-abort{fill:#3d1d14;stroke:#ff9a78}
.smc-graph .g-safe{fill:#11322f;stroke:#5cc9bb}
.smc-graph .g-rule{stroke:#465060}
.smc-graph .g-unrun .g-line,.smc-graph .g-unrun .g-box{stroke:#c4a1ff}
.smc-graph .g-mark{fill:#ffcf33;stroke:#5c4700}
.smc-graph .g-mark.g-error{fill:#ff6b5e;stroke:#7a130b}
.smc-graph .g-bang{fill:#3d2f00}
}
</style>
<rect class="g-back" width="648" height="422" rx="8"/>
<g><title>initial state</title><circle class="g-start" cx="308" cy="18" r="5"/><path class="g-line" d="M308 36v-16"/><path class="g-head" d="M308 42l-4 -9h8z"/></g>
<g class="g-edge"><title>Idle to Fill: armed</title><path class="g-line" d="M308 76V126M308 144V156"/><path class="g-head" d="M308 162l-4 -9h8z"/><text class="g-guard g-mid" x="308" y="139">armed</text></g>
<g class="g-edge"><title>Fill to Abort: pressure &gt; 800 or pressure &lt; 1
or: T &gt; 60000</title><path class="g-line" d="M251 232C251 249 113 249 113 267M113 307V366"/><path class="g-head" d="M113 372l-4 -9h8z"/><text class="g-guard g-mid" x="113" y="280">pressure &gt; 800 or pressure &lt; 1</text><path class="g-rule" d="M26 287h175"/><text class="g-guard g-mid" x="113" y="302">T &gt; 60000</text></g>
<g class="g-edge"><title>Fill to Done: pressure &gt; 500 and armed</title><path class="g-line" d="M308 232V267V278M308 296V307V366"/><path class="g-head" d="M308 372l-4 -9h8z"/><text class="g-guard g-mid" x="308" y="291">pressure &gt; 500 and armed</text></g>
<g class="g-edge"><title>Fill to Fill: pressure == 499</title><path class="g-line" d="M374 189c28 -10 32 16 6 16"/><path class="g-head" d="M374 205l9 -4v8z"/><text class="g-guard" x="406" y="201">pressure == 499</text></g>
<g class="g-edge g-never"><title>Abort to Idle: 1 &gt; 2 (never)</title><path class="g-line" d="M142 372C142 339 522 339 522 307V267V232V162V144M522 126C522 104 323 104 323 82"/><path class="g-head" d="M323 76l-4 9h8z"/><text class="g-guard g-mid" x="522" y="139">1 &gt; 2</text></g>
<g class="g-edge g-never"><title>Lost to Idle: on entry (never)</title><path class="g-line" d="M594 180V162V144M594 126C594 104 337 104 337 82"/><path class="g-head" d="M337 76l-4 9h8z"/><text class="g-guard g-mid" x="594" y="139">on entry</text></g>
<g class="g-node"><title>Idle, initial state</title><rect class="g-box g-state" x="270" y="42" width="76" height="34" rx="6"/><text class="g-name" x="308" y="64">Idle</text></g>
<g class="g-node"><title>Fill</title><rect class="g-box g-state" x="242" y="162" width="132" height="70" rx="6"/><text class="g-name" x="308" y="184">Fill</text><path class="g-rule" d="M255 192h106"/><text class="g-block" x="255" y="207">entry</text><text class="g-guard" x="289" y="207">valve = true</text><text class="g-block" x="255" y="221">exit</text><text class="g-guard" x="289" y="221">valve = false</text></g>
<g class="g-node"><title>Abort, @abort</title><path class="g-box g-abort" d="M86 372h54l11 11v12l-11 11h-54l-11 -11v-12z"/><text class="g-name" x="113" y="394">Abort</text></g>
<g class="g-node"><title>Done, @safe, @swap</title><rect class="g-box g-safe" x="270" y="372" width="76" height="34" rx="17"/><rect class="g-in g-safe" x="274" y="376" width="68" height="26" rx="13"/><text class="g-name" x="308" y="394">Done</text></g>
<g class="g-node g-never"><title>Lost, unreachable</title><rect class="g-box g-state" x="556" y="180" width="76" height="34" rx="6"/><text class="g-name" x="594" y="202">Lost</text></g>
</svg>
