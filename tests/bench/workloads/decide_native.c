// SPDX-License-Identifier: Apache-2.0
// The decisions as a flight-software engineer writes them: the same conditionals on native types.
#include "tests/bench/workloads/decide.h"

static inline int16_t to_i16(int x) { return (int16_t)(x < INT16_MIN ? INT16_MIN : x > INT16_MAX ? INT16_MAX : x); }

void decide_native_init(DecideNative *m, DecideSv *sv)
{
    m->first = true;
    sv->state = 1;
}

void decide_native_step(DecideNative *m, DecideSv *sv)
{
    if (m->first) {
        m->first = false;
        sv->state = 1;
    }
    if (!sv->cold && sv->speed < 9000) {
        if (sv->temp > -100) {
            if (sv->hot) {
                if (sv->armed) {
                    if (sv->command < 128) {
                        if (sv->fuel >= 20) {
                            if (sv->flow >= 2) {
                                sv->valve = sv->flow / 3;
                            } else {
                                sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                            }
                        }
                        if (sv->hot) {
                            if (sv->cold) {
                                if (sv->thrust > 4000 || sv->mode > 2) {
                                    if (sv->cold) {
                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                    }
                                }
                            } else {
                                sv->valve = sv->flow / 6;
                                sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                            }
                        }
                    }
                } else {
                    sv->open = sv->hot | sv->armed;
                    if (sv->temp >= -100 || sv->lox >= 30) {
                        if (!sv->hot) {
                            if (sv->vibe > 50) {
                                sv->code = 7;
                            } else {
                                sv->valve = sv->flow / 3;
                            }
                        }
                    } else {
                        sv->vote = -41;
                    }
                }
            }
        }
        if (sv->vibe > 200) {
            if (sv->fuel > 10) {
                if (sv->fuel >= 40) {
                    if (sv->armed) {
                        if (sv->lox >= 20 || sv->temp >= 100) {
                            if (sv->hot) {
                                if (sv->wet) {
                                    if (sv->hot) {
                                        if (sv->command > 128) {
                                            if (sv->chamber > 20) {
                                                if (sv->speed > 15000) {
                                                    if (sv->fuel < 40 || sv->vibe >= 50) {
                                                        sv->open = sv->hot | sv->armed;
                                                        sv->vote = -39;
                                                    }
                                                } else {
                                                    sv->code = 12;
                                                    sv->vote = -37;
                                                }
                                            } else {
                                                if (sv->armed) {
                                                    sv->valve = sv->flow / 2;
                                                    sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                } else {
                                                    sv->vote = -34;
                                                }
                                                if (sv->cold) {
                                                    sv->open = sv->hot | sv->armed;
                                                }
                                            }
                                            sv->valve = sv->flow / 6;
                                        } else {
                                            if (sv->bus < 27000) {
                                                sv->open = sv->hot | sv->armed;
                                                if (sv->hot) {
                                                    if (sv->armed) {
                                                        sv->open = sv->hot | sv->armed;
                                                    } else {
                                                        sv->trim = to_i16(sv->vibe - 21);
                                                        sv->vote = -28;
                                                    }
                                                    if (sv->thrust >= 2000) {
                                                        sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                    } else {
                                                        sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                    }
                                                }
                                            }
                                        }
                                    }
                                } else {
                                    sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                    sv->vote = -23;
                                }
                            }
                            sv->valve = sv->flow / 2;
                        } else {
                            sv->trim = to_i16(sv->vibe - 29);
                            sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                        }
                    }
                } else {
                    sv->open = sv->hot | sv->armed;
                }
            } else {
                sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                sv->vote = -17;
            }
        }
    } else {
        if (sv->mode > 3) {
            if (sv->thrust > 8000) {
                if (sv->chamber < 50) {
                    if (!sv->hot) {
                        if (sv->cold) {
                            if (sv->lox > 10) {
                                sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                            } else {
                                sv->code = 35;
                                sv->code = 36;
                            }
                        } else {
                            if (sv->temp > 250) {
                                if (sv->wet) {
                                    sv->open = sv->hot | sv->armed;
                                } else {
                                    sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                    sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                }
                                sv->trim = to_i16(sv->vibe - 40);
                            }
                        }
                    } else {
                        if (sv->bus < 27000) {
                            if (sv->bus < 25000) {
                                if (sv->vibe >= 200) {
                                    if (sv->command < 128 || sv->speed < 15000) {
                                        if (sv->flow < 6 && sv->armed) {
                                            if (sv->bus > 23000) {
                                                if (sv->mode > 3) {
                                                    sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                }
                                                sv->valve = sv->flow / 2;
                                            } else {
                                                sv->vote = -7;
                                                sv->valve = sv->flow / 4;
                                            }
                                            sv->trim = to_i16(sv->vibe - 45);
                                        } else {
                                            sv->vote = -4;
                                            sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                        }
                                        if (sv->vibe >= 200) {
                                            if (sv->command >= 128 || sv->lox >= 20) {
                                                sv->open = sv->hot | sv->armed;
                                            } else {
                                                sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                            }
                                        }
                                    }
                                    if (!sv->wet) {
                                        if (sv->flow < 2) {
                                            if (sv->speed < 15000) {
                                                sv->code = 50;
                                            } else {
                                                if (sv->bus > 21000) {
                                                    if (sv->mode > 2) {
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                    } else {
                                                        sv->trim = to_i16(sv->vibe - 52);
                                                    }
                                                } else {
                                                    sv->code = 53;
                                                    sv->valve = sv->flow / 7;
                                                }
                                                if (sv->thrust > 8000) {
                                                    if (sv->chamber < 65 || sv->speed < 15000) {
                                                        sv->code = 55;
                                                    }
                                                    sv->valve = sv->flow / 2;
                                                }
                                            }
                                        }
                                    } else {
                                        if (sv->temp >= 0) {
                                            sv->trim = to_i16(sv->vibe - 57);
                                        }
                                    }
                                } else {
                                    sv->valve = sv->flow / 4;
                                }
                                if (sv->cold || sv->hot) {
                                    if (sv->wet) {
                                        if (sv->fuel > 10 || !sv->hot) {
                                            sv->vote = 9;
                                            if (sv->command < 64) {
                                                if (sv->hot) {
                                                    if (sv->speed < 9000) {
                                                        sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                    } else {
                                                        sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                    }
                                                    sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                }
                                                if (sv->command < 64) {
                                                    if (sv->mode > 3) {
                                                        sv->trim = to_i16(sv->vibe - 63);
                                                        sv->trim = to_i16(sv->vibe - 64);
                                                    }
                                                } else {
                                                    sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                }
                                            }
                                        } else {
                                            sv->code = 66;
                                        }
                                    } else {
                                        if (sv->lox >= 10) {
                                            if (!sv->cold) {
                                                if (sv->chamber < 50) {
                                                    if (sv->speed >= 9000) {
                                                        sv->vote = 17;
                                                    } else {
                                                        sv->open = sv->hot | sv->armed;
                                                    }
                                                    if (sv->command > 32) {
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                        sv->trim = to_i16(sv->vibe - 70);
                                                    }
                                                }
                                                if (sv->lox >= 50) {
                                                    if (sv->cold) {
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                        sv->valve = sv->flow / 4;
                                                    } else {
                                                        sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                    }
                                                } else {
                                                    sv->trim = to_i16(sv->vibe - 74);
                                                }
                                            }
                                            if (sv->mode == 3 && sv->chamber > 20) {
                                                if (sv->wet && sv->speed >= 15000) {
                                                    if (sv->bus > 27000 || sv->armed) {
                                                        sv->trim = to_i16(sv->vibe - 75);
                                                    }
                                                }
                                                sv->code = 76;
                                            }
                                        } else {
                                            sv->trim = to_i16(sv->vibe - 77);
                                        }
                                        sv->valve = sv->flow / 3;
                                    }
                                }
                            } else {
                                if (sv->hot && sv->vibe < -50) {
                                    sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                }
                            }
                        }
                    }
                    if (sv->lox > 40 && sv->cold) {
                        if (sv->thrust < 6000) {
                            sv->vote = 30;
                            if (sv->wet) {
                                if (sv->lox < 10 && sv->command < 128) {
                                    if (sv->command >= 64) {
                                        if (sv->bus > 25000) {
                                            if (sv->fuel < 20) {
                                                if (sv->flow < 2) {
                                                    if (sv->chamber > 50) {
                                                        sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                    }
                                                } else {
                                                    sv->open = sv->hot | sv->armed;
                                                    if (sv->thrust >= 2000) {
                                                        sv->vote = 33;
                                                        sv->vote = 34;
                                                    } else {
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                        sv->code = 86;
                                                    }
                                                }
                                                if (sv->mode > 1) {
                                                    sv->valve = sv->flow / 5;
                                                } else {
                                                    sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                    sv->code = 89;
                                                }
                                            }
                                        }
                                        if (sv->mode != 3) {
                                            if (sv->command > 128 || !sv->wet) {
                                                if (sv->vibe >= 200 && sv->lox > 30) {
                                                    if (sv->lox >= 40 && sv->wet) {
                                                        sv->trim = to_i16(sv->vibe - 90);
                                                    } else {
                                                        sv->open = sv->hot | sv->armed;
                                                    }
                                                } else {
                                                    if (sv->temp >= 100 || sv->hot) {
                                                        sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                                                    } else {
                                                        sv->vote = 43;
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                    }
                                                }
                                            }
                                        }
                                    } else {
                                        if (sv->vibe >= -50) {
                                            if (sv->chamber >= 80 && !sv->armed) {
                                                sv->vote = 45;
                                                if (sv->vibe < 200) {
                                                    sv->trim = to_i16(sv->vibe - 96);
                                                } else {
                                                    sv->valve = sv->flow / 8;
                                                    sv->vote = 48;
                                                }
                                            } else {
                                                if (sv->speed >= 12000) {
                                                    if (sv->thrust >= 8000) {
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                    } else {
                                                        sv->open = sv->hot | sv->armed;
                                                    }
                                                    sv->code = 101;
                                                } else {
                                                    sv->trim = to_i16(sv->vibe - 102);
                                                }
                                            }
                                        } else {
                                            sv->valve = sv->flow / 7;
                                            sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                        }
                                    }
                                    if (sv->thrust < 8000) {
                                        if (sv->flow > 4) {
                                            if (sv->armed) {
                                                if (sv->lox < 50) {
                                                    if (sv->flow > 6) {
                                                        sv->code = 105;
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                    } else {
                                                        sv->trim = to_i16(sv->vibe - 107);
                                                    }
                                                }
                                                if (sv->chamber > 80) {
                                                    sv->vote = -42;
                                                }
                                            } else {
                                                sv->open = sv->hot | sv->armed;
                                            }
                                        }
                                        if (sv->thrust >= 2000 || sv->mode == 2) {
                                            if (sv->fuel >= 50 || sv->mode == 3) {
                                                if (sv->bus < 23000) {
                                                    sv->vote = -40;
                                                } else {
                                                    sv->trim = to_i16(sv->vibe - 111);
                                                    sv->vote = -38;
                                                }
                                                if (sv->lox >= 20) {
                                                    if (sv->cold && sv->vibe < 50) {
                                                        sv->valve = sv->flow / 3;
                                                    } else {
                                                        sv->valve = sv->flow / 4;
                                                    }
                                                } else {
                                                    if (!sv->cold) {
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                        sv->code = 116;
                                                    } else {
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                    }
                                                    if (sv->mode != 3) {
                                                        sv->code = 118;
                                                    }
                                                }
                                            }
                                        } else {
                                            if (sv->thrust >= 2000 && sv->wet) {
                                                if (sv->lox < 40) {
                                                    if (sv->hot) {
                                                        sv->vote = -31;
                                                    }
                                                } else {
                                                    if (sv->bus < 27000) {
                                                        sv->code = 120;
                                                    } else {
                                                        sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                                                        sv->open = sv->hot | sv->armed;
                                                    }
                                                }
                                            }
                                        }
                                    }
                                } else {
                                    sv->trim = to_i16(sv->vibe - 123);
                                    sv->open = sv->hot | sv->armed;
                                }
                            } else {
                                sv->open = sv->hot | sv->armed;
                            }
                        } else {
                            sv->warnings = (uint8_t)(sv->warnings + (sv->warnings < UINT8_MAX));
                            sv->code = 127;
                        }
                    } else {
                        sv->level = (uint8_t)(sv->level + (sv->level < UINT8_MAX));
                    }
                } else {
                    sv->valve = sv->flow / 5;
                }
            } else {
                sv->code = 130;
            }
        } else {
            if (sv->chamber < 80) {
                if (sv->flow > 8) {
                    sv->trim = to_i16(sv->vibe - 131);
                }
            }
        }
    }
    sv->spark = (sv->code > 65) & (sv->level > 20);
    sv->alarm = (sv->warnings > 100) | (sv->vote < -40);
    if (sv->level > 200)
        sv->level = 0;
    if (sv->warnings > 200)
        sv->warnings = 0;
}
