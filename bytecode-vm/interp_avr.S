// SPDX-License-Identifier: Apache-2.0
// Runs a step of a machine on AVR, with the image in flash.  Its results equal those of interp.c bit for bit.  interp_avr_eeprom.S is the
// same for images in flash or EEPROM.  This file fetches, loads, stores and jumps; number_avr.S, which it includes, does arithmetic.
//
// Registers between instructions:
//   r9:r2    X: an F64, or a whole number in r5:r2        r17  bit 0: X is an F64, bit 1: Y is an F64
//   r15:r14  the locals        r13:r12  the state vector        Y  SmVm, which includes register Y        Z  the next byte of the image
// and within an instruction
//   r16      the opcode        r19:r18  its first operand, in r21:r18 if it can have 32 bits
// Calls preserve r2 to r17.
#if defined(__AVR_HAVE_MUL__) && !defined(SMVM_PORTABLE)
#include "bytecode-vm/interp_avr.h"

; Macros that read the next byte of the image.
#ifdef SMVM_EEPROM
#define STEP smvm_step_eeprom
#define LOAD smvm_load_eeprom
#define STORE smvm_store_eeprom
#include <avr/io.h>
.macro from_eeprom to                     ; bit 7 of r31 must be clear
	out _SFR_IO_ADDR(EEARH), r31
	out _SFR_IO_ADDR(EEARL), r30
	sbi _SFR_IO_ADDR(EECR), EERE
	in \to, _SFR_IO_ADDR(EEDR)
	adiw r30, 1
.endm
.macro fetch_here to, second              ; inline, for hot code: from flash or EEPROM, two bytes if there is a second register
	sbrs r31, 7
	rjmp .Lflash\@
.Lwait\@:
	sbic _SFR_IO_ADDR(EECR), EEPE
	rjmp .Lwait\@
	andi r31, 0x7F
	from_eeprom \to
	.ifnb \second
	from_eeprom \second
	.endif
	ori r31, 0x80
.Lgot\@:
	.subsection 1
.Lflash\@:
	lpm \to, Z+
	.ifnb \second
	lpm \second, Z+
	.endif
	rjmp .Lgot\@
	.previous
.endm
.macro if_long                            ; branches to a target that is too far for a branch instruction
	brlo decode
	rjmp longer
.endm
.macro fetch to
	rcall read
	.ifnc \to, r0
	mov \to, r0
	.endif
.endm
#else
#define STEP smvm_step_flash
#define LOAD smvm_load_flash
#define STORE smvm_store_flash
.macro fetch_here to, second
	lpm \to, Z+
	.ifnb \second
	lpm \second, Z+
	.endif
.endm
.macro if_long
	brsh longer
.endm
.macro fetch to
	lpm \to, Z+
.endm
#endif

.macro xcall name
#ifdef __AVR_HAVE_JMP_CALL__
	call \name
#else
	rcall \name
#endif
.endm

; A varint of the bytes b, b1 is 0x60 + (b - 0x60) * 0x80 + b1, which equals b * 0x80 + b1 - TWO_LESS.
#define TWO_LESS (0x60 * 0x80 - 0x60)

; Sets Z to the start of a table of the image, or to the start of the code.
.macro image_at table
	ldd r30, Y+\table
	ldd r31, Y+\table+1
	ldd r0, Y+VM_IMAGE
	add r30, r0
	ldd r0, Y+VM_IMAGE+1
	adc r31, r0
.endm

; Doubles the offset in r19:r18.
.macro twice
	lsl r18
	rol r19
.endm

.macro place                              ; adds the offset r19:r18 to the pointer r27:r26
	add r26, r18
	adc r27, r19
.endm

	.section .text.STEP, "ax", @progbits

; Reads the other bytes of a varint of two or four bytes; r18 is the first.
long_number:
	cpi r18, 0x78
	brsh four_bytes
	mov r19, r18
	clr r18
	lsr r19
	ror r18
	fetch r0
	or r18, r0
	subi r18, lo8(TWO_LESS)
	sbci r19, hi8(TWO_LESS)
	ret
four_bytes:
	andi r18, 7
	clr r19
	clr r20
	ldi r23, 3
2:	mov r21, r20
	mov r20, r19
	mov r19, r18
	clr r18
	lsr r21
	ror r20
	ror r19
	ror r18
	fetch r0
	or r18, r0
	dec r23
	brne 2b
	subi r18, 0xA0                    ; + 0xC60
	sbci r19, 0xF3
	sbci r20, 0xFF
	sbci r21, 0xFF
	ret

; Reads an entry of the table of functions, r18 bytes, into r21:r20.
entry:
	fetch r20
	clr r21
	cpi r18, 1
	breq 1f
	fetch r21
	cpi r18, 2
	breq 1f
	fetch r0
1:	ret

; ---- a single instruction ----

	.section .progmem.data.STEP, "a", @progbits
just_end:
	.byte 0xCE, 0xCE
	.previous

; SmF64 LOAD(uint8_t type, const void *at): the result of `ldx_local`
	.global LOAD
	.type LOAD, @function
LOAD:
	set
	clc
	rjmp entered

; void STORE(SmF64 x, uint8_t type, void *at): executes `st_local`
	.global STORE
	.type STORE, @function
STORE:
	set
	sec
	rjmp entered

cell:
	brcs 1f
	mov r16, r24
	ori r16, 0x80
	movw r14, r22
	rcall alone
	rcall x_to_f64
	rjmp step_over
1:	ori r16, 0xC0
	rcall a_to_x
	rcall alone
	rjmp step_over

alone:                                    ; runs a single instruction, opcode r16, with operand 0
	clr r18
	clr r19
	ldi r30, lo8(just_end)
	ldi r31, hi8(just_end)
	rjmp decode

; ---- a step ----

; SmResult STEP(SmVm *vm, void *sv)
	.global STEP
	.type STEP, @function
STEP:
	clt
entered:                                  ; LOAD and STORE join here with T set; carry set means STORE
	.irp r, 2, 3, 4, 5, 6, 7, 8, 9, 12, 13, 14, 15, 16, 17, 28, 29
	push r\r
	.endr
	brts cell
	movw r28, r24
	movw r12, r22
	ldd r14, Y+VM_LOCAL
	ldd r15, Y+VM_LOCAL+1
	add r14, r28
	adc r15, r29
	clr r17
	ldd r26, Y+VM_G                   ; has G advanced, and is it not the largest value?
	ldd r27, Y+VM_G+1
	add r26, r12
	adc r27, r13
	ld r18, X+
	ldd r0, Y+VM_NEXT
	cp r18, r0
	.irp i, 1, 2, 3, 4, 5, 6, 7
	ld 18+\i, X+
	ldd r0, Y+VM_NEXT+\i
	cpc 18+\i, r0
	.endr
	brcs refused
	subi r18, 0xFF                    ; + 1
	sbci r19, 0xFF
	sbci r20, 0xFF
	sbci r21, 0xFF
	brcc upper
advanced:
	.irp i, 0, 1, 2, 3, 4, 5, 6, 7
	std Y+VM_NEXT+\i, 18+\i
	.endr
	std Y+VM_STORED, r1
	ldd r16, Y+VM_FLAGS
	tst r16
	brne not_plain
body:
	ldd r30, Y+VM_BODY
	ldd r31, Y+VM_BODY+1
	rcall next
	sbiw r24, 0
	brne leaves                       ; else r25:r24 is STEP_OK
step_over:
	.irp r, 29, 28, 17, 16, 15, 14, 13, 12, 9, 8, 7, 6, 5, 4, 3, 2
	pop r\r
	.endr
	ret
upper:
	subi r22, 0xFF
	sbci r23, 0xFF
	sbci r24, 0xFF
	sbci r25, 0xFF
	brcs advanced
refused:
	ldi r24, lo8(STEP_REFUSED)
	ldi r25, hi8(STEP_REFUSED)
	rjmp step_over

leaves:                                   ; a transition to state r25:r24
	movw r26, r24
	ldi r22, 2
	rcall block
	std Y+VM_STATE, r26
	std Y+VM_STATE+1, r27
	rcall next
	ldd r16, Y+VM_FLAGS
	ori r16, 1 << VM_FIRST
	std Y+VM_FLAGS, r16
	clr r24
	clr r25
	rjmp step_over

; The first or second step of a state, or a step of a machine with samples or more than eight outputs.  r25:r18 is the value of VM_NEXT.
not_plain:
	bst r16, VM_FIRST
	bld r16, VM_ENTERED
	brtc 2f
	.irp i, 0, 1, 2, 3, 4, 5, 6, 7
	std Y+VM_START+\i, 18+\i
	.endr
	ldd r26, Y+VM_S
	ldd r27, Y+VM_S+1
	add r26, r12
	adc r27, r13
	ldd r0, Y+VM_STATE
	st X+, r0
	ldd r0, Y+VM_STATE+1
	st X+, r0
	st X+, r1
	st X, r1
	ldi r16, 1 << VM_ENTERED          ; computes the flags for the later steps of the state
	image_at VM_FUNCTIONS
	ldd r24, Y+VM_FUNCTIONS
	ldd r25, Y+VM_FUNCTIONS+1
	ldd r20, Y+VM_OUTPUTS
	ldd r21, Y+VM_OUTPUTS+1
	sub r24, r20                      ; an output takes three bytes
	sbc r25, r21
	sbiw r24, 3 * 8 + 1
	brcs 1f
	ori r16, 1 << VM_MANY
1:	ldd r18, Y+VM_WIDTH
	rcall entry                       ; the sample function begins at 0, so this is its size
	or r20, r21
	breq 1f
	ori r16, 1 << VM_SAMPLES
1:	ldi r22, 1
	rcall block
	std Y+VM_BODY, r30
	std Y+VM_BODY+1, r31
2:	std Y+VM_FLAGS, r16
	sbrs r16, VM_MANY
	rjmp 5f
	.irp i, 1, 2, 3, 4, 5, 6, 7
	std Y+VM_STORED+\i, r1
	.endr
	ldd r24, Y+VM_MORE_BYTES          ; clears the bits of outputs from 64 on
	ldd r25, Y+VM_MORE_BYTES+1
	ldd r26, Y+VM_MORE
	ldd r27, Y+VM_MORE+1
	add r26, r28
	adc r27, r29
4:	sbiw r24, 1
	brcs 5f
	st X+, r1
	rjmp 4b
5:	sbrs r16, VM_SAMPLES
	rjmp 6f
	clr r24
	clr r25
	rcall code_at
	rcall next
6:	ldd r16, Y+VM_FLAGS
	sbrs r16, VM_ENTERED
	rjmp body
	clr r22
	rcall block
	rcall next
	sbiw r24, 0
	breq 7f
	rjmp leaves
7:	rjmp body

; ---- functions ----

; Sets Z to the start of block r22 of the state: 0 entry, 1 step, 2 exit.
block:
	ldd r24, Y+VM_STATE
	ldd r25, Y+VM_STATE+1
	movw r20, r24
	lsl r24
	rol r25
	add r24, r20
	adc r25, r21
	sbiw r24, 3
	add r24, r22
	adc r25, r1
	image_at VM_FUNCTIONS
	ldd r18, Y+VM_WIDTH
	mov r19, r18
1:	add r30, r24
	adc r31, r25
	dec r19
	brne 1b
	rcall entry
	movw r24, r20
	rcall entry
	ldi r30, lo8(just_end)
	ldi r31, hi8(just_end)
	cp r20, r24
	cpc r21, r25
	breq 1f
code_at:                                  ; sets Z to offset r25:r24 in the code
	image_at VM_CODE
	add r30, r24
	adc r31, r25
1:	ret

; The interpreter loop.  `rcall next` runs the function that starts at Z; it returns in r25:r24 the state of its transition, or 0.

longer:
	cpi r18, 0x78
	brsh 8f
	mov r19, r18
	clr r18
	lsr r19
	ror r18
	fetch_here r0
	or r18, r0
	subi r18, lo8(TWO_LESS)
	sbci r19, hi8(TWO_LESS)
	cpi r16, 0xE0
	brlo 9f
; jxn, jf or jt.  For jf and jt, which have no second operand, the result of comparing X with n is not used.
with_n:
	sbrc r17, 0
	rjmp with_real
	cp r2, r18
	cpc r3, r19
	cpc r4, r1
	cpc r5, r1
compared:
	ldi r24, 1
	brlt related
	ldi r24, 2
	breq related
	ldi r24, 4
related:
	fetch_here r22
	cpi r22, 0x60
	brsh 7f
	and r24, r16
	breq next
	add r30, r22
	adc r31, r1
	rjmp next
7:	rjmp far
8:	cpi r16, 0xCE
	breq end
	rjmp longest
end:
	clr r24
	clr r25
	ret
9:	rjmp decode

half:
	twice
	place
	ld r18, X+
	ld r19, X
	clr r20
	sbrc r19, 7
	rjmp half_signed
	clr r21
whole:                                    ; sets X or Y to the whole number r21:r18
	sbrc r16, 5
	rjmp whole_y
whole_x:
	movw r2, r18
	movw r4, r20
	andi r17, 2
next:
	fetch_here r16, r18               ; fetches the opcode and the next byte, which is arbitrary after the last opcode
	clr r19
	cpi r18, 0x60
	if_long
decode:
	sbrc r16, 6
	rjmp no_load
	sbrc r16, 3
	rjmp wide
	movw r26, r14
	sbrc r16, 4
	movw r26, r12
	sbrc r16, 1
	rjmp words
	sbrc r16, 0
	rjmp half
	place
	ld r18, X
	clr r19
	sbrs r18, 7
	rjmp 1f
	sbrs r16, 2
	com r19
1:	mov r20, r19
	mov r21, r19
	rjmp whole
half_signed:
	sbrs r16, 2
	com r20
	mov r21, r20
	rjmp whole
whole_y:
	std Y+VM_Y, r18
	std Y+VM_Y+1, r19
	std Y+VM_Y+2, r20
	std Y+VM_Y+3, r21
	andi r17, 1
	rjmp next

longest:
	cpi r18, 0x80
	brsh no_number
	rcall four_bytes
	cpi r16, 0xE0
	brsh 2f
	mov r24, r16
	andi r24, 0xDE
	cpi r24, 0x9E
	brne 1f
	rjmp plus
1:	cpi r24, 0x8C
	breq 3f
	rjmp decode
3:	rjmp number_32
2:	sbrc r17, 0
	rjmp with_real_long
	cp r2, r18
	cpc r3, r19
	cpc r4, r20
	cpc r5, r21
	rjmp compared
no_number:
	sbiw r30, 1                       ; steps back: the byte fetched as an operand is the next opcode
	sbrs r16, 6
	rjmp time
	rjmp compute

leave:
	movw r24, r18
	ret

far:
	cpi r22, 0x80
	brsh jf_jt
	mov r18, r22
	rcall long_number
	and r24, r16
	breq 1f
	rjmp jump
1:	rjmp next
jf_jt:
	sbiw r30, 1
	movw r26, r18
	rcall x_truth
	movw r18, r26
	eor r24, r16
	sbrs r24, 0
	rjmp jump
	rjmp next

time:                                     ; sets X or Y to T
	.irp i, 0, 1, 2, 3, 4, 5, 6, 7
	ldd 18+\i, Y+VM_NEXT+\i
	ldd r0, Y+VM_START+\i
	.if \i
	sbc 18+\i, r0
	.else
	sub 18+\i, r0
	.endif
	.endr
	rjmp long

words:                                    ; loads four or eight bytes
	sbrs r16, 0
	rjmp 2f
eight:
	twice
	twice
	twice
	place
	ld r18, X+
	ld r19, X+
	ld r20, X+
	ld r21, X+
	ld r22, X+
	ld r23, X+
	ld r24, X+
	ld r25, X
	sbrc r16, 3
	rjmp real
long:                                     ; an I64 or U64 in r25:r18
	mov r0, r22
	or r0, r23
	or r0, r24
	or r0, r25
	brne 1f
	sbrs r21, 7
	rjmp whole
1:	rcall from_long
	brtc given
	rjmp whole
2:	twice
	twice
	place
	ld r18, X+
	ld r19, X+
	ld r20, X+
	ld r21, X
	sbrc r16, 2
	sbrs r21, 7
	rjmp whole
	clr r22                           ; a U32 beyond the range of I32
	clr r23
	movw r24, r22
	rjmp 1b

wide:                                     ; loads an F32, F64, bool or RAW
	sbrc r16, 2
	rjmp others
	movw r26, r14
	sbrc r16, 4
	movw r26, r12
	sbrc r16, 0
	rjmp eight
	sbrs r16, 1
	rjmp f32
	place
	ld r18, X
bool:
	cpse r18, r1
	ldi r18, 1
	clr r19
	clr r20
	clr r21
	rjmp whole
f32:
	twice
	twice
	place
	ld r22, X+
	ld r23, X+
	ld r24, X+
	ld r25, X
read_f32:
	rcall from_f32
real:                                     ; r25:r18 is an F64 or RAW
	mov r26, r25
	ori r26, 0x80
	cpi r26, 0xFF
	brne given
	sbrs r16, 1
	rcall no_nan
given:                                    ; sets X or Y to the F64 r25:r18
	sbrc r16, 5
	rjmp 1f
given_x:
	movw r2, r18
	movw r4, r20
	movw r6, r22
	movw r8, r24
	ori r17, 1
	rjmp next
1:	rcall a_to_y
	rjmp next

; ---- constants, and operations that do not access memory ----

others:
	sbrc r16, 4
	rjmp 1f
	sbrc r16, 1
	rjmp constant
	clr r20
	clr r21
number_32:
	sbrs r16, 0
	rjmp whole                        ; n
	com r18                           ; -1 - n
	com r19
	com r20
	com r21
	rjmp whole
1:	sbrs r16, 1
	rjmp 3f
	sbrc r16, 5
	rjmp set_or_fn
	clr r20
	clr r21
	rjmp plus
set_or_fn:
	sbrs r16, 0
	rjmp set
; Calls function r18 of X, or from 16 on of X and Y.
	mov r16, r18
	cpi r16, 16
	brlo 2f
	rcall y_to_a
	rcall a_to_y
2:	rcall x_to_f64
	.irp r, 14, 15, 17, 30, 31
	push r\r
	.endr
	movw r14, r28
	clr r17
	xcall smvm_call_function
	.irp r, 31, 30, 17, 15, 14
	pop r\r
	.endr
	rjmp given_x
set:
	mov r16, r18
	rcall relate
	and r24, r16
truth_x:                                  ; X = whether r24 is not 0
	mov r18, r24
	andi r16, 0x1F
	rjmp bool

constant:                                 ; sets X or Y to an F32 or F64 constant
	push r30
	push r31
	twice
	twice
	movw r26, r18
	image_at VM_F32S
	sbrs r16, 0
	rjmp 5f
	lsl r26
	rol r27
	image_at VM_F64S
5:	add r30, r26
	adc r31, r27
	sbrs r16, 0
	rjmp 6f
	fetch r18
	fetch r19
	fetch r20
	fetch r21
6:	fetch r22
	fetch r23
	fetch r24
	fetch r25
	pop r31
	pop r30
	sbrs r16, 0
	rcall from_f32
	rjmp given

3:	sbrc r16, 5
	rjmp cvt
	mov r16, r18                      ; stat
	fetch r18
	clr r19
	cpi r18, 0x60
	brlo 4f
	rcall long_number
4:	push r30
	push r31
	mov r22, r16
	movw r20, r18
	movw r24, r28
	xcall smvm_compute_statistic
	pop r31
	pop r30
	rjmp given_x

cvt:
	mov r16, r18
	rcall convert
	sbrs r16, 3
	rjmp long
	sbrc r16, 0
	rjmp given_x                      ; F64
	sbrc r16, 1
	rjmp whole_x                      ; bool
	movw r22, r18
	movw r24, r20
	rjmp read_f32

; ---- stores ----

out_further:
	movw r22, r18
	ldi r25, 3
1:	lsr r23
	ror r22
	dec r25
	brne 1b
	movw r26, r28
	adiw r26, VM_STORED
	cpi r22, 8
	cpc r23, r1
	brlo 2f
	ldd r26, Y+VM_MORE                ; the bits of outputs from 64 on follow the locals
	ldd r27, Y+VM_MORE+1
	sbiw r26, 8
	add r26, r28
	adc r27, r29
2:	add r26, r22
	adc r27, r23
	ld r0, X
	or r0, r24
	st X, r0
	rjmp output

no_load:                                  ; 0xC0 and above
	sbrc r16, 5
	rjmp with_n
	sbrc r16, 4
	rjmp jumps
	andi r16, 0x0F
	movw r26, r14
	cpi r16, 12
	brlo store
	breq out
	cpi r16, 14
	brsh 2f
	rjmp leave                        ; goto
2:	breq 3f
	rjmp sample
3:	rjmp end

out:
	ldi r24, 1                        ; the mask of its bit in VM_STORED
	sbrc r18, 1
	ldi r24, 4
	sbrc r18, 0
	lsl r24
	sbrc r18, 2
	swap r24
	cpi r18, 8
	cpc r19, r1
	brsh out_further
	ldd r0, Y+VM_STORED
	or r0, r24
	std Y+VM_STORED, r0
output:
	movw r24, r30                     ; saves Z
	movw r26, r18
	twice
	add r26, r18
	adc r27, r19
	image_at VM_OUTPUTS
	add r30, r26
	adc r31, r27
	fetch r18
	fetch r19
	fetch r16
	andi r16, 0x0F
	movw r30, r24
	movw r26, r12
; Stores X as type r16 at base r27:r26 plus r19:r18 units of the size of the type.
store:
	sbrc r16, 3
	rjmp store_wide
	sbrc r17, 0
	rjmp put
	sbrc r16, 1
	rjmp store_words
	clr r0
	sbrc r16, 0
	rjmp 2f
	sbrs r16, 2                       ; one byte, if the others are its sign extension
	sbrs r2, 7
	rjmp 1f
	com r0
1:	cp r3, r0
	cpc r4, r0
	cpc r5, r0
	brne put
	place
	st X, r2
	rjmp next
2:	sbrs r16, 2                       ; two bytes, likewise
	sbrs r3, 7
	rjmp 3f
	com r0
3:	cp r4, r0
	cpc r5, r0
	brne put
	twice
	place
	st X+, r2
	st X, r3
	rjmp next

put:                                      ; stores a value that needs conversion
	mov r24, r16                      ; the size is 1 << r24
	andi r24, 3
	sbrs r16, 3
	rjmp 1f
	ldi r24, 3
	sbrc r16, 0
	rjmp 1f
	ldi r24, 2
	sbrc r16, 1
	clr r24
1:	mov r25, r24
2:	subi r25, 1
	brcs 3f
	twice
	rjmp 2b
3:	place
	push r24
	push r26
	push r27
	rcall convert
	pop r27
	pop r26
	pop r0
	st X+, r18
	dec r0
	brmi 4f
	st X+, r19
	dec r0
	brmi 4f
	st X+, r20
	st X+, r21
	dec r0
	brmi 4f
	st X+, r22
	st X+, r23
	st X+, r24
	st X, r25
4:	rjmp next

store_words:
	clr r0
	sbrs r5, 7
	rjmp 1f
	sbrc r16, 2
	rjmp put                          ; X is below 0
	com r0
1:	twice
	twice
	sbrc r16, 0
	rjmp 2f
	place
	st X+, r2
	st X+, r3
	st X+, r4
	st X, r5
	rjmp next
2:	twice
	place
	st X+, r2
	st X+, r3
	st X+, r4
	st X+, r5
	st X+, r0
	st X+, r0
	st X+, r0
	st X, r0
	rjmp next

store_wide:
	sbrs r16, 0
	rjmp 2f
	sbrs r17, 0
	rjmp put                          ; a whole number to an F64
	mov r24, r9
	lsl r24
	cpi r24, 0xFE
	brne 1f
	rjmp put                          ; may be NaN
1:	twice
	twice
	twice
	place
	.irp r, 2, 3, 4, 5, 6, 7, 8, 9
	st X+, r\r
	.endr
	rjmp next
2:	sbrc r16, 1                       ; an F32 or a bool
	sbrc r17, 0
	rjmp put
	place
	mov r18, r2
	or r18, r3
	or r18, r4
	or r18, r5
	breq 3f
	ldi r18, 1
3:	st X, r18
	rjmp next

sample:
	push r30
	push r31
	push r18
	push r19
	twice
	twice
	image_at VM_WINDOWS
	add r30, r18
	adc r31, r19
	adiw r30, 2
	fetch r16                   ; its bits 1 to 4 are the type of the window
	lsr r16
	andi r16, 0x0F
	rcall convert
	rcall a_to_y
	pop r23
	pop r22
	movw r24, r28
	xcall smvm_add_sample
	pop r31
	pop r30
	rjmp next


; ---- jumps ----

jumps:                                    ; 0xD0 to 0xDF
	cpi r16, 0xDF
	brne jxy
jump:
	add r30, r18
	adc r31, r19
	rjmp next
jxy:
	movw r26, r18
	rcall relate
	movw r18, r26
	and r24, r16
	brne jump
	rjmp next

; Compares an F64 with a number below 2^16.  Usually the integer part decides.
with_real_long:
	mov r24, r20
	or r24, r21
	brne 5f
with_real:
	clr r20
	clr r21
	movw r24, r8
	sbrc r25, 7
	rjmp 4f
	subi r24, lo8(0x3FF0)             ; exponent of X, times 16
	sbci r25, hi8(0x3FF0)
	brcs 3f
	tst r25
	brne 6f                           ; X is 2^16 or more
	mov r23, r24
	swap r23
	andi r23, 0x0F
	mov r25, r24
	andi r25, 0x0F
	ori r25, 0x10
	mov r24, r7
	subi r23, 12                      ; r25:r24 is 2^12 or more
	breq 2f
	brcc 7f
1:	lsr r25
	ror r24
	inc r23
	brne 1b
2:	cp r24, r18
	cpc r25, r19
	breq 5f
	brsh 9f
less:
	ldi r24, 1
	rjmp related
3:	mov r24, r18                      ; X is from 0 to below 1
	or r24, r19
	brne less
	rjmp 5f
4:	cpi r25, 0xFF                     ; X is negative, except for NaN and -0
	breq 5f
	cpi r25, 0x80
	brne less
5:	mov r24, r16                      ; the comparison is not needed for jf and jt
	inc r24
	andi r24, 0x0E
	brne 1f
	rjmp related
1:	rcall relate_n
	rjmp related
6:	cpi r25, 0x40
	brsh 5b                           ; infinite or NaN
9:	ldi r24, 4
	rjmp related
7:	mov r26, r6
8:	lsl r26
	rol r24
	rol r25
	dec r23
	brne 8b
	rjmp 2b

#include "bytecode-vm/number_avr.S"

#ifdef SMVM_EEPROM
read:                                     ; reads the next byte into r0
	fetch_here r0
	ret
#endif
#endif
