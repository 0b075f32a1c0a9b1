# Of an else if that is too long for a picture, the condition that decides is shown.
args graph app.sm

-- app.sm --
[state_vector]
U64 G
U32 S
F64 highest @read_only
F64 pad @read_only
F64 baro @read_only
bool on
[Coast]
.step
    on = false
    if T > 2000 and highest - pad > 300 and roll_median(baro, 9) < highest - 10: -> Drogue
    else if T > 25000: -> Drogue
    else if baro < 3 or T > 30000: -> Drogue
[Drogue]
.step
    on = true
-- stdout --
<svg xmlns="http://www.w3.org/2000/svg" class="smc-graph" role="img" stroke-width="1.4" width="240" height="254" viewBox="0 0 240 254">
<title>State diagram of app</title>
<desc>2 states, 3 transitions. The initial state is Coast.</desc>
<style>
.smc-graph text{font-family:Helvetica,Arial,sans-serif;font-size:11px}
.smc-graph .g-name{font-size:13px;font-weight:bold;text-anchor:middle}
.smc-graph .g-to{font-weight:bold;text-anchor:middle}
.smc-graph .g-mid{text-anchor:middle}
.smc-graph .g-end{text-anchor:end}
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
<rect class="g-back" width="240" height="254" rx="8"/>
<g><title>initial state</title><circle class="g-start" cx="120" cy="18" r="5"/><path class="g-line" d="M120 36v-16"/><path class="g-head" d="M120 42l-4 -9h8z"/></g>
<g class="g-edge"><title>Coast to Drogue: T &gt; 2000 and highest - pad &gt; 300 and roll_median(baro, 9) &lt; highest - 10
or: not (T &gt; 2000 and highest - pad &gt; 300 and roll_median(baro, 9) &lt; highest - 10) and T &gt; 25000
or: not (T &gt; 2000 and highest - pad &gt; 300 and roll_median(baro, 9) &lt; highest - 10) and not (T &gt; 25000) and (baro &lt; 3 or T &gt; 30000)</title><path class="g-line" d="M120 76V96M120 184V198"/><path class="g-head" d="M120 204l-4 -9h8z"/><text class="g-guard g-mid" x="120" y="109">T &gt; 2000 and highest - pad &gt; 300</text><text class="g-guard g-mid" x="120" y="123">and roll_median(baro, 9)</text><text class="g-guard g-mid" x="120" y="137">&lt; highest - 10</text><path class="g-rule" d="M26 143h189"/><text class="g-guard g-mid" x="120" y="158">else, T &gt; 25000</text><path class="g-rule" d="M26 164h189"/><text class="g-guard g-mid" x="120" y="179">else, baro &lt; 3 or T &gt; 30000</text></g>
<g class="g-node"><title>Coast, initial state</title><rect class="g-box g-state" x="82" y="42" width="76" height="34" rx="6"/><text class="g-name" x="120" y="64">Coast</text></g>
<g class="g-node"><title>Drogue</title><rect class="g-box g-state" x="77" y="204" width="86" height="34" rx="6"/><text class="g-name" x="120" y="226">Drogue</text></g>
</svg>
