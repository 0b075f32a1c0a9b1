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
<svg xmlns="http://www.w3.org/2000/svg" class="smc-graph" role="img" stroke-width="1.4" width="300" height="338" viewBox="0 0 300 338">
<title>State diagram of app</title>
<desc>2 states, 3 transitions. The initial state is Coast.</desc>
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
<rect class="g-back" width="300" height="338" rx="8"/>
<g><title>initial state</title><circle class="g-start" cx="150" cy="18" r="5"/><path class="g-line" d="M150 36v-16"/><path class="g-head" d="M150 42l-4 -9h8z"/></g>
<g class="g-edge"><title>Coast to Drogue: T &gt; 2000 and highest - pad &gt; 300 and roll_median(baro, 9) &lt; highest - 10
or: not (T &gt; 2000 and highest - pad &gt; 300 and roll_median(baro, 9) &lt; highest - 10) and T &gt; 25000
or: not (T &gt; 2000 and highest - pad &gt; 300 and roll_median(baro, 9) &lt; highest - 10) and not (T &gt; 25000) and (baro &lt; 3 or T &gt; 30000)</title><path class="g-line" d="M150 98V116M150 248V260"/><path class="g-head" d="M150 266l-4 -9h8z"/><text class="g-guard g-mid" x="150" y="129">T &gt; 2000 and highest - pad &gt; 300</text><text class="g-guard g-mid" x="150" y="143">and roll_median(baro, 9) &lt; highest - 10</text><path class="g-rule" d="M26 150h249"/><text class="g-guard g-mid" x="150" y="165">not (T &gt; 2000 and highest - pad &gt; 300</text><text class="g-guard g-mid" x="150" y="179">and roll_median(baro, 9) &lt; highest - 10)</text><text class="g-guard g-mid" x="150" y="193">and T &gt; 25000</text><path class="g-rule" d="M26 200h249"/><text class="g-guard g-mid" x="150" y="215">not (T &gt; 2000 and highest - pad &gt; 300</text><text class="g-guard g-mid" x="150" y="229">and roll_median(baro, 9) &lt; highest - 10) and</text><text class="g-guard g-mid" x="150" y="243">not (T &gt; 25000) and (baro &lt; 3 or T &gt; 30000)</text></g>
<g class="g-node"><title>Coast, initial state</title><rect class="g-box g-state" x="91" y="42" width="118" height="56" rx="6"/><text class="g-name" x="150" y="64">Coast</text><path class="g-rule" d="M104 72h92"/><text class="g-block" x="104" y="87">step</text><text class="g-guard" x="138" y="87">on = false</text></g>
<g class="g-node"><title>Drogue</title><rect class="g-box g-state" x="93" y="266" width="114" height="56" rx="6"/><text class="g-name" x="150" y="288">Drogue</text><path class="g-rule" d="M106 296h88"/><text class="g-block" x="106" y="311">step</text><text class="g-guard" x="140" y="311">on = true</text></g>
</svg>
