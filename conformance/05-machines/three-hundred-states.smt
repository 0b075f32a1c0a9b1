spec 5.22, 5.4  State numbers go beyond 255.

-- app.sm --
[state_vector]
U64 G
U32 S

[S1]
.step -> S2
[S2]
.step -> S3
[S3]
.step -> S4
[S4]
.step -> S5
[S5]
.step -> S6
[S6]
.step -> S7
[S7]
.step -> S8
[S8]
.step -> S9
[S9]
.step -> S10
[S10]
.step -> S11
[S11]
.step -> S12
[S12]
.step -> S13
[S13]
.step -> S14
[S14]
.step -> S15
[S15]
.step -> S16
[S16]
.step -> S17
[S17]
.step -> S18
[S18]
.step -> S19
[S19]
.step -> S20
[S20]
.step -> S21
[S21]
.step -> S22
[S22]
.step -> S23
[S23]
.step -> S24
[S24]
.step -> S25
[S25]
.step -> S26
[S26]
.step -> S27
[S27]
.step -> S28
[S28]
.step -> S29
[S29]
.step -> S30
[S30]
.step -> S31
[S31]
.step -> S32
[S32]
.step -> S33
[S33]
.step -> S34
[S34]
.step -> S35
[S35]
.step -> S36
[S36]
.step -> S37
[S37]
.step -> S38
[S38]
.step -> S39
[S39]
.step -> S40
[S40]
.step -> S41
[S41]
.step -> S42
[S42]
.step -> S43
[S43]
.step -> S44
[S44]
.step -> S45
[S45]
.step -> S46
[S46]
.step -> S47
[S47]
.step -> S48
[S48]
.step -> S49
[S49]
.step -> S50
[S50]
.step -> S51
[S51]
.step -> S52
[S52]
.step -> S53
[S53]
.step -> S54
[S54]
.step -> S55
[S55]
.step -> S56
[S56]
.step -> S57
[S57]
.step -> S58
[S58]
.step -> S59
[S59]
.step -> S60
[S60]
.step -> S61
[S61]
.step -> S62
[S62]
.step -> S63
[S63]
.step -> S64
[S64]
.step -> S65
[S65]
.step -> S66
[S66]
.step -> S67
[S67]
.step -> S68
[S68]
.step -> S69
[S69]
.step -> S70
[S70]
.step -> S71
[S71]
.step -> S72
[S72]
.step -> S73
[S73]
.step -> S74
[S74]
.step -> S75
[S75]
.step -> S76
[S76]
.step -> S77
[S77]
.step -> S78
[S78]
.step -> S79
[S79]
.step -> S80
[S80]
.step -> S81
[S81]
.step -> S82
[S82]
.step -> S83
[S83]
.step -> S84
[S84]
.step -> S85
[S85]
.step -> S86
[S86]
.step -> S87
[S87]
.step -> S88
[S88]
.step -> S89
[S89]
.step -> S90
[S90]
.step -> S91
[S91]
.step -> S92
[S92]
.step -> S93
[S93]
.step -> S94
[S94]
.step -> S95
[S95]
.step -> S96
[S96]
.step -> S97
[S97]
.step -> S98
[S98]
.step -> S99
[S99]
.step -> S100
[S100]
.step -> S101
[S101]
.step -> S102
[S102]
.step -> S103
[S103]
.step -> S104
[S104]
.step -> S105
[S105]
.step -> S106
[S106]
.step -> S107
[S107]
.step -> S108
[S108]
.step -> S109
[S109]
.step -> S110
[S110]
.step -> S111
[S111]
.step -> S112
[S112]
.step -> S113
[S113]
.step -> S114
[S114]
.step -> S115
[S115]
.step -> S116
[S116]
.step -> S117
[S117]
.step -> S118
[S118]
.step -> S119
[S119]
.step -> S120
[S120]
.step -> S121
[S121]
.step -> S122
[S122]
.step -> S123
[S123]
.step -> S124
[S124]
.step -> S125
[S125]
.step -> S126
[S126]
.step -> S127
[S127]
.step -> S128
[S128]
.step -> S129
[S129]
.step -> S130
[S130]
.step -> S131
[S131]
.step -> S132
[S132]
.step -> S133
[S133]
.step -> S134
[S134]
.step -> S135
[S135]
.step -> S136
[S136]
.step -> S137
[S137]
.step -> S138
[S138]
.step -> S139
[S139]
.step -> S140
[S140]
.step -> S141
[S141]
.step -> S142
[S142]
.step -> S143
[S143]
.step -> S144
[S144]
.step -> S145
[S145]
.step -> S146
[S146]
.step -> S147
[S147]
.step -> S148
[S148]
.step -> S149
[S149]
.step -> S150
[S150]
.step -> S151
[S151]
.step -> S152
[S152]
.step -> S153
[S153]
.step -> S154
[S154]
.step -> S155
[S155]
.step -> S156
[S156]
.step -> S157
[S157]
.step -> S158
[S158]
.step -> S159
[S159]
.step -> S160
[S160]
.step -> S161
[S161]
.step -> S162
[S162]
.step -> S163
[S163]
.step -> S164
[S164]
.step -> S165
[S165]
.step -> S166
[S166]
.step -> S167
[S167]
.step -> S168
[S168]
.step -> S169
[S169]
.step -> S170
[S170]
.step -> S171
[S171]
.step -> S172
[S172]
.step -> S173
[S173]
.step -> S174
[S174]
.step -> S175
[S175]
.step -> S176
[S176]
.step -> S177
[S177]
.step -> S178
[S178]
.step -> S179
[S179]
.step -> S180
[S180]
.step -> S181
[S181]
.step -> S182
[S182]
.step -> S183
[S183]
.step -> S184
[S184]
.step -> S185
[S185]
.step -> S186
[S186]
.step -> S187
[S187]
.step -> S188
[S188]
.step -> S189
[S189]
.step -> S190
[S190]
.step -> S191
[S191]
.step -> S192
[S192]
.step -> S193
[S193]
.step -> S194
[S194]
.step -> S195
[S195]
.step -> S196
[S196]
.step -> S197
[S197]
.step -> S198
[S198]
.step -> S199
[S199]
.step -> S200
[S200]
.step -> S201
[S201]
.step -> S202
[S202]
.step -> S203
[S203]
.step -> S204
[S204]
.step -> S205
[S205]
.step -> S206
[S206]
.step -> S207
[S207]
.step -> S208
[S208]
.step -> S209
[S209]
.step -> S210
[S210]
.step -> S211
[S211]
.step -> S212
[S212]
.step -> S213
[S213]
.step -> S214
[S214]
.step -> S215
[S215]
.step -> S216
[S216]
.step -> S217
[S217]
.step -> S218
[S218]
.step -> S219
[S219]
.step -> S220
[S220]
.step -> S221
[S221]
.step -> S222
[S222]
.step -> S223
[S223]
.step -> S224
[S224]
.step -> S225
[S225]
.step -> S226
[S226]
.step -> S227
[S227]
.step -> S228
[S228]
.step -> S229
[S229]
.step -> S230
[S230]
.step -> S231
[S231]
.step -> S232
[S232]
.step -> S233
[S233]
.step -> S234
[S234]
.step -> S235
[S235]
.step -> S236
[S236]
.step -> S237
[S237]
.step -> S238
[S238]
.step -> S239
[S239]
.step -> S240
[S240]
.step -> S241
[S241]
.step -> S242
[S242]
.step -> S243
[S243]
.step -> S244
[S244]
.step -> S245
[S245]
.step -> S246
[S246]
.step -> S247
[S247]
.step -> S248
[S248]
.step -> S249
[S249]
.step -> S250
[S250]
.step -> S251
[S251]
.step -> S252
[S252]
.step -> S253
[S253]
.step -> S254
[S254]
.step -> S255
[S255]
.step -> S256
[S256]
.step -> S257
[S257]
.step -> S258
[S258]
.step -> S259
[S259]
.step -> S260
[S260]
.step -> S261
[S261]
.step -> S262
[S262]
.step -> S263
[S263]
.step -> S264
[S264]
.step -> S265
[S265]
.step -> S266
[S266]
.step -> S267
[S267]
.step -> S268
[S268]
.step -> S269
[S269]
.step -> S270
[S270]
.step -> S271
[S271]
.step -> S272
[S272]
.step -> S273
[S273]
.step -> S274
[S274]
.step -> S275
[S275]
.step -> S276
[S276]
.step -> S277
[S277]
.step -> S278
[S278]
.step -> S279
[S279]
.step -> S280
[S280]
.step -> S281
[S281]
.step -> S282
[S282]
.step -> S283
[S283]
.step -> S284
[S284]
.step -> S285
[S285]
.step -> S286
[S286]
.step -> S287
[S287]
.step -> S288
[S288]
.step -> S289
[S289]
.step -> S290
[S290]
.step -> S291
[S291]
.step -> S292
[S292]
.step -> S293
[S293]
.step -> S294
[S294]
.step -> S295
[S295]
.step -> S296
[S296]
.step -> S297
[S297]
.step -> S298
[S298]
.step -> S299
[S299]
.step -> S300
[S300]
.step -> S1

-- app.ss --
[options]
delta_t 1

[all_states]
G == 299: @assert S == 300
G == 300: @assert S == 1
G == 300: @stop
