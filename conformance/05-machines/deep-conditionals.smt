spec 5.32  Forty conditionals within each other.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 a
F64 x

[Run]
.step
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
                                                                                                                                                                }
                                                                                                                                                            }
                                                                                                                                                        }
                                                                                                                                                    }
                                                                                                                                                }
                                                                                                                                            }
                                                                                                                                        }
                                                                                                                                    }
                                                                                                                                }
                                                                                                                            }
                                                                                                                        }
                                                                                                                    }
                                                                                                                }
                                                                                                            }
                                                                                                        }
                                                                                                    }
                                                                                                }
                                                                                            }
                                                                                        }
                                                                                    }
                                                                                }
                                                                            }
                                                                        }
                                                                    }
                                                                }
                                                            }
                                                        }
                                                    }
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }

-- app.ss --
[options]
delta_t 1

[all_states]
true: a = G
G == 0: @assert x == 0
G == 17: @assert x == 17
G == 40: @assert x == 40
G == 40: @stop
