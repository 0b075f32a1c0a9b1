// SPDX-License-Identifier: Apache-2.0
// The style sheet.  Colours are variables, with values for light and for dark; paper is always light.  Bands of states (.s0 to .s7) each
// have their own lightness, and patterns over them (plot_states.c), so that they are distinguishable in greyscale.
#include "compiler/report/page_style.h"

#define LIGHT \
    ":root{--bg:#fff;--fg:#1b2733;--dim:#5b6b7a;--line:#d5dde4;--soft:#f3f6f9;--link:#0b5cad;--accent:#0b5cad;--mark:#ffe08a;" \
    "--good:#1a7f4b;--bad:#b3261e;--note:#8a5a00;--trace:#123f73;--trace-soft:#9db8d6;color-scheme:light dark}\n"

#define PLOTS \
    ".plot{display:block;width:100%;font-size:12px}.plot text{fill:var(--fg)}.plot .dim{fill:var(--dim)}" \
    ".plot .frame{fill:none;stroke:var(--line)}.plot .grid{stroke:var(--line);stroke-width:.6}" \
    ".plot .trace{fill:none;stroke:var(--trace);stroke-width:1.4;stroke-linejoin:round}.plot .on{fill:var(--trace)}" \
    ".plot .recorded{fill:none;stroke:var(--bad);stroke-width:1.2;stroke-dasharray:4 2}.plot .recorded-on{fill:var(--bad)}" \
    ".plot .recorded-name{fill:var(--bad)}" \
    ".plot .both{fill:var(--trace-soft)}.plot .begin{fill:var(--bg);stroke:var(--bad);stroke-width:1.6}" \
    ".plot .cut{stroke:var(--dim);stroke-width:.7;stroke-dasharray:2 3}.plot .hatch{stroke:#000;stroke-opacity:.35;stroke-width:1}" \
    ".plot .tint{fill-opacity:.13}.plot .name{fill:#10202e;font-weight:600}\n" \
    ".s0{fill:#d6e6f7}.s1{fill:#e2a55e}.s2{fill:#bfe5c7}.s3{fill:#cf8aa2}.s4{fill:#ece2fb}.s5{fill:#d3bd45}.s6{fill:#8fcbcf}.s7{" \
    "fill:#a3a3a3}\n"

const char plot_style_light[] = LIGHT, plot_style[] = PLOTS;

const char *const report_style[] = {
    LIGHT,
    "@media (prefers-color-scheme:dark){:root{--bg:#12181f;--fg:#dfe7ee;--dim:#93a3b3;--line:#2f3a45;--soft:#1a222b;--link:#7db8f5;"
    "--accent:#7db8f5;--mark:#6b5410;--good:#5cc48e;--bad:#ff8a80;--note:#e8b04b;--trace:#9ccaff;--trace-soft:#3f5d80}}\n",
    "@media "
    "print{:root{--bg:#fff;--fg:#000;--dim:#444;--line:#bbb;--soft:#f4f4f4;--link:#000;--accent:#000;--mark:#ddd;--good:#000;"
    "--bad:#000;--note:#000;--trace:#000;--trace-soft:#999;color-scheme:light}}\n",
    "*{box-sizing:border-box}\n",
    "body{margin:0 auto;max-width:70rem;padding:0 1.5rem 3rem;background:var(--bg);color:var(--fg);"
    "font:16px/1.5 system-ui,-apple-system,\"Segoe UI\",Roboto,\"DejaVu Sans\",sans-serif}\n",
    "code,pre{font-family:ui-monospace,\"SF Mono\",Menlo,Consolas,\"DejaVu Sans Mono\",monospace;font-size:.9em}\n",
    "a{color:var(--link);text-decoration:none}a:hover{text-decoration:underline}\n",
    "header{border-bottom:3px solid var(--accent);margin-bottom:1.5rem;padding-top:2rem}\n",
    "h1{font-size:2.4rem;line-height:1.1;margin:0}header>p{color:var(--dim);margin:.3rem 0 1rem}\n",
    "nav{display:grid;grid-template-columns:repeat(auto-fill,minmax(13rem,1fr));gap:.6rem 1.5rem;margin:0 0 1rem;font-size:.95rem}"
    "nav ul{list-style:none;margin:0;padding:0}\n",
    ".chapter{font-size:1.9rem;line-height:1.2;font-weight:700;color:var(--accent);margin:3.5rem 0 -1rem}\n",
    "section{margin:2.5rem 0}h2{font-size:1.5rem;border-bottom:1px solid var(--line);padding-bottom:.25rem;margin:0 0 1rem}\n",
    "h3{font-size:1.1rem;margin:1.4rem 0 .4rem}article{margin-bottom:1.2rem}p{margin:.5rem 0}\n",
    "blockquote{margin:.4rem 0 .6rem;padding:.1rem 0 .1rem .8rem;border-left:3px solid var(--line);color:var(--dim);"
    "white-space:pre-line}\n",
    ".wide{overflow-x:auto}table{border-collapse:collapse;width:100%;font-size:.93rem;margin:.4rem 0 1rem}\n",
    "th,td{text-align:left;vertical-align:top;padding:.35rem .6rem;border-bottom:1px solid var(--line)}\n",
    "th{color:var(--dim);font-weight:600;border-bottom:2px solid var(--line)}tbody tr:hover{background:var(--soft)}\n",
    "table.narrow{width:auto}table.dense{font-size:.8rem}.dense td,.dense th{padding:.25rem}.dense .badge{font-size:.7rem;padding:.05rem "
    ".3rem;border-radius:.3rem}wbr{display:none}p,li,td "
    "code{overflow-wrap:break-word}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}td.b,th.b{white-space:nowrap;font-"
    "variant-numeric:tabular-nums}code.b,span.b{white-space:nowrap}\n",
    "details{margin:-.4rem 0 1rem}summary{color:var(--dim);font-size:.93rem;cursor:pointer}\n",
    ".bar{display:inline-block;width:7rem;height:.7em;background:var(--soft);border:1px solid var(--line);margin-right:.4em}"
    ".bar i{display:block;border-top:.6em solid var(--accent)}\n",
    "dl{display:grid;grid-template-columns:repeat(auto-fill,minmax(15rem,1fr));gap:.6rem;margin:.8rem 0 1.2rem}\n",
    "dl div{background:var(--soft);border:1px solid var(--line);border-radius:6px;padding:.5rem .8rem}\n",
    "dt{color:var(--dim);font-size:.85rem}dd{margin:0;font-weight:600;overflow-wrap:anywhere}\n",
    ".do{margin:.4rem 0}.do b{font-weight:600}.do ul{margin:.1rem 0 .3rem;padding-left:1.4rem}.do li{margin:.1rem 0}.do "
    ".c{display:block;color:var(--dim);font-size:.92em;white-space:pre-line}\n",
    ".ln{color:var(--dim);font-size:.8rem;font-variant-numeric:tabular-nums}.do .ln::before{content:\"line "
    "\"}.st{font-weight:600}\n",
    ".badge{font-size:.75rem;font-weight:600;padding:.1rem .5rem;border-radius:1rem;border:1px solid currentColor;"
    "vertical-align:middle;white-space:nowrap}a.badge{color:var(--note)}"
    ".good,a.good{color:var(--good)}.bad,a.bad{color:var(--bad)}.note{color:var(--note)}\n",
    "pre{background:var(--soft);border:1px solid var(--line);border-radius:6px;padding:.5rem "
    ".8rem;overflow-x:auto;line-height:1.45;"
    "margin:.4rem 0}pre "
    ".no{display:inline-block;width:3.2em;padding-right:1em;text-align:right;color:var(--dim);user-select:none}\n",
    "pre .c{color:var(--dim);font-style:italic}mark{background:var(--mark);color:inherit;border-radius:2px}\n",
    ".source span:target{background:var(--mark)}.label{color:var(--dim);margin:.2rem 0 .6rem}\n",
    "figure{margin:1rem 0;overflow-x:auto}figcaption{color:var(--dim);font-size:.9rem}figure svg{max-width:100%;height:auto}\n"
    "@media screen{figure.diagram{margin:1rem calc(50% - 50vw + 1.5rem);text-align:center}"
    "figure.diagram>svg{max-width:max(100%,var(--width)*.8)}.print{display:none}.dense th wbr{display:inline}}\n"
    ".upright th:not(:first-child){writing-mode:vertical-rl}.upright th:first-child{vertical-align:bottom}"
    "th.b,.upright th{white-space:nowrap}.upright th wbr{display:none!important}\n",
    "footer{border-top:1px solid var(--line);color:var(--dim);font-size:.85rem;margin-top:3rem}\n",
    PLOTS,
    "@media print{html{font-size:10pt}body{max-width:none;padding:0 "
    "1px;font-size:10pt;line-height:1.35}th,td{padding:.2rem .5rem}header{padding-top:0;margin-bottom:.8rem}section{margin:0 0 5mm}"
    "article,tr,figure,blockquote,.ex,dl div,.do li{break-inside:avoid}article:has(tr:nth-child(9)){break-inside:auto}"
    "tbody tr:first-child,p:has(+.wide){break-after:avoid}td wbr,th wbr{display:inline}"
    ".dense td,.dense th{padding:.2rem .15rem}.dense .badge{white-space:normal}tbody tr:last-child{break-before:avoid}"
    "h2,h3,.do b{break-after:avoid}#scripts article{break-inside:auto}#scripts blockquote{break-after:avoid}"
    "a{color:inherit}.wide,pre,figure{overflow:visible}"
    "pre{white-space:pre-wrap}.source{font-size:8.5pt;border:0;background:none;padding:0}thead{display:table-header-group}"
    ".chapter{font-size:15pt;margin:6mm 0 2mm;break-after:avoid}nav{display:none}figure{margin:.3rem 0}"
    "figure svg{width:auto;max-height:215mm}figure.low svg{max-height:110mm}"
    "figure.tall,figure.large{break-inside:auto}figure.tall>svg,figure.large>svg{display:none}"
    ".screen{display:none}.print{display:block}.chapter:has(+section>figure.large){margin-top:0}"
    ".print svg{display:block;break-inside:avoid;max-width:100%;max-height:none}"
    "article>figure.large,section:has(>figure.large),.chapter:has(+section>figure.large){page:large}"
    "dl{grid-template-columns:repeat(4,minmax(0,1fr));gap:.3rem;margin:.5rem 0 .8rem}dl div{padding:.2rem .5rem}"
    "tbody tr:hover{background:none}.badge{border:1px solid #000}\n"
    "@page{margin:16mm 14mm;@bottom-right{content:counter(page) \" of \" counter(pages);font:9pt sans-serif}}\n"
    "@page large{size:landscape;margin:11mm 8mm}}\n",
    0};
