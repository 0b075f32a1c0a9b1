" SPDX-License-Identifier: Apache-2.0
" Opens the files of editors.txt, and writes to $EDITORS_OUT which words are not in the expected group, then the counts.
set nocompatible nomore noswapfile nomodeline
let &runtimepath = 'editors/vim,' . $VIMRUNTIME
filetype on
syntax on
let s:lines = []
let s:passed = 0

func s:check(what, got, expected)
  if a:got ==# a:expected
    let s:passed += 1
  else
    call add(s:lines, a:what . ': expected ' . a:expected . ', got ' . a:got)
  endif
endfunc

for s:row in readfile('tests/check/editors.txt')
  if s:row =~# '^#'
    continue
  endif
  let [s:file, s:text, s:token, s:scope, s:group] = map(split(s:row, ' | '), 'trim(v:val)')
  if s:file !=# @%
    silent execute 'edit' s:file
  endif
  let s:at = search('\V\^\s\*\zs' . escape(s:text, '\'), 'cw')
  let s:column = stridx(getline(s:at), s:text) + strridx(s:text, s:token) + 1
  let s:name = s:at ? synIDattr(synID(s:at, s:column, 1), 'name') : 'no such line'
  call s:check(s:file . ': ' . s:text . ': ' . s:token, s:name ==# '' ? '-' : s:name, s:group)
  call s:check(s:file . ': filetype', &filetype, 'smc')
endfor
" Files of other languages keep their type.
for [s:ending, s:first] in [['sv', 'module top;'], ['ss', '#lang racket'], ['ss', '(define x 1)']]
  let s:file = $EDITORS_OUT . '.' . s:ending
  call writefile([s:first], s:file)
  silent execute 'edit!' s:file
  call s:check(s:first . ': is smc', &filetype ==# 'smc', 0)
  bwipeout!
  call delete(s:file)
endfor
call writefile(s:lines + [s:passed . ' ' . len(s:lines)], $EDITORS_OUT)
qall!
