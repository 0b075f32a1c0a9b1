" SPDX-License-Identifier: Apache-2.0
" Files of smc.  Other languages have .sv and .ss, too: those of smc begin with a comment or a section.
autocmd BufNewFile,BufRead *.sm,*.io,*.app,*.net,*.rq set filetype=smc
autocmd BufRead *.sv,*.ss if getline(nextnonblank(1)) =~# '^\s*\%(\[\|#\%([!|]\|lang\)\@!\)' | set filetype=smc | endif
