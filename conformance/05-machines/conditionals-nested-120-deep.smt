spec 5.32, 5.34  Conditionals may nest deeply, each with its own else.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x
F64 y

[Run]
.step
    y = 0
    if a > 0 {
    x = 1
        if a > 1 {
    x = 2
            if a > 2 {
    x = 3
                if a > 3 {
    x = 4
                    if a > 4 {
    x = 5
                        if a > 5 {
    x = 6
                            if a > 6 {
    x = 7
                                if a > 7 {
    x = 8
    if a > 8 {
    x = 9
        if a > 9 {
    x = 10
            if a > 10 {
    x = 11
                if a > 11 {
    x = 12
                    if a > 12 {
    x = 13
                        if a > 13 {
    x = 14
                            if a > 14 {
    x = 15
                                if a > 15 {
    x = 16
    if a > 16 {
    x = 17
        if a > 17 {
    x = 18
            if a > 18 {
    x = 19
                if a > 19 {
    x = 20
                    if a > 20 {
    x = 21
                        if a > 21 {
    x = 22
                            if a > 22 {
    x = 23
                                if a > 23 {
    x = 24
    if a > 24 {
    x = 25
        if a > 25 {
    x = 26
            if a > 26 {
    x = 27
                if a > 27 {
    x = 28
                    if a > 28 {
    x = 29
                        if a > 29 {
    x = 30
                            if a > 30 {
    x = 31
                                if a > 31 {
    x = 32
    if a > 32 {
    x = 33
        if a > 33 {
    x = 34
            if a > 34 {
    x = 35
                if a > 35 {
    x = 36
                    if a > 36 {
    x = 37
                        if a > 37 {
    x = 38
                            if a > 38 {
    x = 39
                                if a > 39 {
    x = 40
    if a > 40 {
    x = 41
        if a > 41 {
    x = 42
            if a > 42 {
    x = 43
                if a > 43 {
    x = 44
                    if a > 44 {
    x = 45
                        if a > 45 {
    x = 46
                            if a > 46 {
    x = 47
                                if a > 47 {
    x = 48
    if a > 48 {
    x = 49
        if a > 49 {
    x = 50
            if a > 50 {
    x = 51
                if a > 51 {
    x = 52
                    if a > 52 {
    x = 53
                        if a > 53 {
    x = 54
                            if a > 54 {
    x = 55
                                if a > 55 {
    x = 56
    if a > 56 {
    x = 57
        if a > 57 {
    x = 58
            if a > 58 {
    x = 59
                if a > 59 {
    x = 60
                    if a > 60 {
    x = 61
                        if a > 61 {
    x = 62
                            if a > 62 {
    x = 63
                                if a > 63 {
    x = 64
    if a > 64 {
    x = 65
        if a > 65 {
    x = 66
            if a > 66 {
    x = 67
                if a > 67 {
    x = 68
                    if a > 68 {
    x = 69
                        if a > 69 {
    x = 70
                            if a > 70 {
    x = 71
                                if a > 71 {
    x = 72
    if a > 72 {
    x = 73
        if a > 73 {
    x = 74
            if a > 74 {
    x = 75
                if a > 75 {
    x = 76
                    if a > 76 {
    x = 77
                        if a > 77 {
    x = 78
                            if a > 78 {
    x = 79
                                if a > 79 {
    x = 80
    if a > 80 {
    x = 81
        if a > 81 {
    x = 82
            if a > 82 {
    x = 83
                if a > 83 {
    x = 84
                    if a > 84 {
    x = 85
                        if a > 85 {
    x = 86
                            if a > 86 {
    x = 87
                                if a > 87 {
    x = 88
    if a > 88 {
    x = 89
        if a > 89 {
    x = 90
            if a > 90 {
    x = 91
                if a > 91 {
    x = 92
                    if a > 92 {
    x = 93
                        if a > 93 {
    x = 94
                            if a > 94 {
    x = 95
                                if a > 95 {
    x = 96
    if a > 96 {
    x = 97
        if a > 97 {
    x = 98
            if a > 98 {
    x = 99
                if a > 99 {
    x = 100
                    if a > 100 {
    x = 101
                        if a > 101 {
    x = 102
                            if a > 102 {
    x = 103
                                if a > 103 {
    x = 104
    if a > 104 {
    x = 105
        if a > 105 {
    x = 106
            if a > 106 {
    x = 107
                if a > 107 {
    x = 108
                    if a > 108 {
    x = 109
                        if a > 109 {
    x = 110
                            if a > 110 {
    x = 111
                                if a > 111 {
    x = 112
    if a > 112 {
    x = 113
        if a > 113 {
    x = 114
            if a > 114 {
    x = 115
                if a > 115 {
    x = 116
                    if a > 116 {
    x = 117
                        if a > 117 {
    x = 118
                            if a > 118 {
    x = 119
                                if a > 119 {
    x = 120
    } else { y = y + 120 }
    } else { y = y + 119 }
    } else { y = y + 118 }
    } else { y = y + 117 }
    } else { y = y + 116 }
    } else { y = y + 115 }
    } else { y = y + 114 }
    } else { y = y + 113 }
    } else { y = y + 112 }
    } else { y = y + 111 }
    } else { y = y + 110 }
    } else { y = y + 109 }
    } else { y = y + 108 }
    } else { y = y + 107 }
    } else { y = y + 106 }
    } else { y = y + 105 }
    } else { y = y + 104 }
    } else { y = y + 103 }
    } else { y = y + 102 }
    } else { y = y + 101 }
    } else { y = y + 100 }
    } else { y = y + 99 }
    } else { y = y + 98 }
    } else { y = y + 97 }
    } else { y = y + 96 }
    } else { y = y + 95 }
    } else { y = y + 94 }
    } else { y = y + 93 }
    } else { y = y + 92 }
    } else { y = y + 91 }
    } else { y = y + 90 }
    } else { y = y + 89 }
    } else { y = y + 88 }
    } else { y = y + 87 }
    } else { y = y + 86 }
    } else { y = y + 85 }
    } else { y = y + 84 }
    } else { y = y + 83 }
    } else { y = y + 82 }
    } else { y = y + 81 }
    } else { y = y + 80 }
    } else { y = y + 79 }
    } else { y = y + 78 }
    } else { y = y + 77 }
    } else { y = y + 76 }
    } else { y = y + 75 }
    } else { y = y + 74 }
    } else { y = y + 73 }
    } else { y = y + 72 }
    } else { y = y + 71 }
    } else { y = y + 70 }
    } else { y = y + 69 }
    } else { y = y + 68 }
    } else { y = y + 67 }
    } else { y = y + 66 }
    } else { y = y + 65 }
    } else { y = y + 64 }
    } else { y = y + 63 }
    } else { y = y + 62 }
    } else { y = y + 61 }
    } else { y = y + 60 }
    } else { y = y + 59 }
    } else { y = y + 58 }
    } else { y = y + 57 }
    } else { y = y + 56 }
    } else { y = y + 55 }
    } else { y = y + 54 }
    } else { y = y + 53 }
    } else { y = y + 52 }
    } else { y = y + 51 }
    } else { y = y + 50 }
    } else { y = y + 49 }
    } else { y = y + 48 }
    } else { y = y + 47 }
    } else { y = y + 46 }
    } else { y = y + 45 }
    } else { y = y + 44 }
    } else { y = y + 43 }
    } else { y = y + 42 }
    } else { y = y + 41 }
    } else { y = y + 40 }
    } else { y = y + 39 }
    } else { y = y + 38 }
    } else { y = y + 37 }
    } else { y = y + 36 }
    } else { y = y + 35 }
    } else { y = y + 34 }
    } else { y = y + 33 }
    } else { y = y + 32 }
    } else { y = y + 31 }
    } else { y = y + 30 }
    } else { y = y + 29 }
    } else { y = y + 28 }
    } else { y = y + 27 }
    } else { y = y + 26 }
    } else { y = y + 25 }
    } else { y = y + 24 }
    } else { y = y + 23 }
    } else { y = y + 22 }
    } else { y = y + 21 }
    } else { y = y + 20 }
    } else { y = y + 19 }
    } else { y = y + 18 }
    } else { y = y + 17 }
    } else { y = y + 16 }
    } else { y = y + 15 }
    } else { y = y + 14 }
    } else { y = y + 13 }
    } else { y = y + 12 }
    } else { y = y + 11 }
    } else { y = y + 10 }
    } else { y = y + 9 }
    } else { y = y + 8 }
    } else { y = y + 7 }
    } else { y = y + 6 }
    } else { y = y + 5 }
    } else { y = y + 4 }
    } else { y = y + 3 }
    } else { y = y + 2 }
    } else { y = y + 1 }

-- app.ss --
[options]
delta_t 1

[all_states]
true: a = G
G == 0: @assert x == 0 and y == 1
G == 17: @assert x == 17 and y == 18
G == 119: @assert x == 119 and y == 120
G == 120: @assert x == 120 and y == 0
G == 120: @stop
