// SPDX-License-Identifier: Apache-2.0
// The decisions by the definitions of the language: every value a double, every store a conversion.
#include "tests/bench/workloads/decide.h"

void decide_f64_init(DecideF64 *m, DecideSv *sv)
{
    frame_init(&m->frame);
    sv->state = 1;
}

static void step(DecideSv *sv)
{
    if (!sv->cold && I(sv->speed) < 9000.0) {
        if (I(sv->temp) > -100.0) {
            if (sv->hot) {
                if (sv->armed) {
                    if (I(sv->command) < 128.0) {
                        if (F(sv->fuel) >= 20.0) {
                            if (F(sv->flow) >= 2.0) {
                                sv->valve = sm_to_f32(F(sv->flow) / 3.0);
                            } else {
                                sv->level = sm_to_u8(I(sv->level) + 1.0);
                            }
                        }
                        if (sv->hot) {
                            if (sv->cold) {
                                if (I(sv->thrust) > 4000.0 || I(sv->mode) > 2.0) {
                                    if (sv->cold) {
                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                    }
                                }
                            } else {
                                sv->valve = sm_to_f32(F(sv->flow) / 6.0);
                                sv->level = sm_to_u8(I(sv->level) + 1.0);
                            }
                        }
                    }
                } else {
                    sv->open = sv->hot || sv->armed;
                    if (I(sv->temp) >= -100.0 || F(sv->lox) >= 30.0) {
                        if (!sv->hot) {
                            if (I(sv->vibe) > 50.0) {
                                sv->code = 7;
                            } else {
                                sv->valve = sm_to_f32(F(sv->flow) / 3.0);
                            }
                        }
                    } else {
                        sv->vote = -41;
                    }
                }
            }
        }
        if (I(sv->vibe) > 200.0) {
            if (F(sv->fuel) > 10.0) {
                if (F(sv->fuel) >= 40.0) {
                    if (sv->armed) {
                        if (F(sv->lox) >= 20.0 || I(sv->temp) >= 100.0) {
                            if (sv->hot) {
                                if (sv->wet) {
                                    if (sv->hot) {
                                        if (I(sv->command) > 128.0) {
                                            if (D(sv->chamber) > 20.0) {
                                                if (I(sv->speed) > 15000.0) {
                                                    if (F(sv->fuel) < 40.0 || I(sv->vibe) >= 50.0) {
                                                        sv->open = sv->hot || sv->armed;
                                                        sv->vote = -39;
                                                    }
                                                } else {
                                                    sv->code = 12;
                                                    sv->vote = -37;
                                                }
                                            } else {
                                                if (sv->armed) {
                                                    sv->valve = sm_to_f32(F(sv->flow) / 2.0);
                                                    sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                } else {
                                                    sv->vote = -34;
                                                }
                                                if (sv->cold) {
                                                    sv->open = sv->hot || sv->armed;
                                                }
                                            }
                                            sv->valve = sm_to_f32(F(sv->flow) / 6.0);
                                        } else {
                                            if (I(sv->bus) < 27000.0) {
                                                sv->open = sv->hot || sv->armed;
                                                if (sv->hot) {
                                                    if (sv->armed) {
                                                        sv->open = sv->hot || sv->armed;
                                                    } else {
                                                        sv->trim = sm_to_i16(I(sv->vibe) - 21.0);
                                                        sv->vote = -28;
                                                    }
                                                    if (I(sv->thrust) >= 2000.0) {
                                                        sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                    } else {
                                                        sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                    }
                                                }
                                            }
                                        }
                                    }
                                } else {
                                    sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                    sv->vote = -23;
                                }
                            }
                            sv->valve = sm_to_f32(F(sv->flow) / 2.0);
                        } else {
                            sv->trim = sm_to_i16(I(sv->vibe) - 29.0);
                            sv->level = sm_to_u8(I(sv->level) + 1.0);
                        }
                    }
                } else {
                    sv->open = sv->hot || sv->armed;
                }
            } else {
                sv->level = sm_to_u8(I(sv->level) + 1.0);
                sv->vote = -17;
            }
        }
    } else {
        if (I(sv->mode) > 3.0) {
            if (I(sv->thrust) > 8000.0) {
                if (D(sv->chamber) < 50.0) {
                    if (!sv->hot) {
                        if (sv->cold) {
                            if (F(sv->lox) > 10.0) {
                                sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                            } else {
                                sv->code = 35;
                                sv->code = 36;
                            }
                        } else {
                            if (I(sv->temp) > 250.0) {
                                if (sv->wet) {
                                    sv->open = sv->hot || sv->armed;
                                } else {
                                    sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                    sv->level = sm_to_u8(I(sv->level) + 1.0);
                                }
                                sv->trim = sm_to_i16(I(sv->vibe) - 40.0);
                            }
                        }
                    } else {
                        if (I(sv->bus) < 27000.0) {
                            if (I(sv->bus) < 25000.0) {
                                if (I(sv->vibe) >= 200.0) {
                                    if (I(sv->command) < 128.0 || I(sv->speed) < 15000.0) {
                                        if (F(sv->flow) < 6.0 && sv->armed) {
                                            if (I(sv->bus) > 23000.0) {
                                                if (I(sv->mode) > 3.0) {
                                                    sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                }
                                                sv->valve = sm_to_f32(F(sv->flow) / 2.0);
                                            } else {
                                                sv->vote = -7;
                                                sv->valve = sm_to_f32(F(sv->flow) / 4.0);
                                            }
                                            sv->trim = sm_to_i16(I(sv->vibe) - 45.0);
                                        } else {
                                            sv->vote = -4;
                                            sv->level = sm_to_u8(I(sv->level) + 1.0);
                                        }
                                        if (I(sv->vibe) >= 200.0) {
                                            if (I(sv->command) >= 128.0 || F(sv->lox) >= 20.0) {
                                                sv->open = sv->hot || sv->armed;
                                            } else {
                                                sv->level = sm_to_u8(I(sv->level) + 1.0);
                                            }
                                        }
                                    }
                                    if (!sv->wet) {
                                        if (F(sv->flow) < 2.0) {
                                            if (I(sv->speed) < 15000.0) {
                                                sv->code = 50;
                                            } else {
                                                if (I(sv->bus) > 21000.0) {
                                                    if (I(sv->mode) > 2.0) {
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                    } else {
                                                        sv->trim = sm_to_i16(I(sv->vibe) - 52.0);
                                                    }
                                                } else {
                                                    sv->code = 53;
                                                    sv->valve = sm_to_f32(F(sv->flow) / 7.0);
                                                }
                                                if (I(sv->thrust) > 8000.0) {
                                                    if (D(sv->chamber) < 65.0 || I(sv->speed) < 15000.0) {
                                                        sv->code = 55;
                                                    }
                                                    sv->valve = sm_to_f32(F(sv->flow) / 2.0);
                                                }
                                            }
                                        }
                                    } else {
                                        if (I(sv->temp) >= 0.0) {
                                            sv->trim = sm_to_i16(I(sv->vibe) - 57.0);
                                        }
                                    }
                                } else {
                                    sv->valve = sm_to_f32(F(sv->flow) / 4.0);
                                }
                                if (sv->cold || sv->hot) {
                                    if (sv->wet) {
                                        if (F(sv->fuel) > 10.0 || !sv->hot) {
                                            sv->vote = 9;
                                            if (I(sv->command) < 64.0) {
                                                if (sv->hot) {
                                                    if (I(sv->speed) < 9000.0) {
                                                        sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                    } else {
                                                        sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                    }
                                                    sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                }
                                                if (I(sv->command) < 64.0) {
                                                    if (I(sv->mode) > 3.0) {
                                                        sv->trim = sm_to_i16(I(sv->vibe) - 63.0);
                                                        sv->trim = sm_to_i16(I(sv->vibe) - 64.0);
                                                    }
                                                } else {
                                                    sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                }
                                            }
                                        } else {
                                            sv->code = 66;
                                        }
                                    } else {
                                        if (F(sv->lox) >= 10.0) {
                                            if (!sv->cold) {
                                                if (D(sv->chamber) < 50.0) {
                                                    if (I(sv->speed) >= 9000.0) {
                                                        sv->vote = 17;
                                                    } else {
                                                        sv->open = sv->hot || sv->armed;
                                                    }
                                                    if (I(sv->command) > 32.0) {
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                        sv->trim = sm_to_i16(I(sv->vibe) - 70.0);
                                                    }
                                                }
                                                if (F(sv->lox) >= 50.0) {
                                                    if (sv->cold) {
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                        sv->valve = sm_to_f32(F(sv->flow) / 4.0);
                                                    } else {
                                                        sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                    }
                                                } else {
                                                    sv->trim = sm_to_i16(I(sv->vibe) - 74.0);
                                                }
                                            }
                                            if (I(sv->mode) == 3.0 && D(sv->chamber) > 20.0) {
                                                if (sv->wet && I(sv->speed) >= 15000.0) {
                                                    if (I(sv->bus) > 27000.0 || sv->armed) {
                                                        sv->trim = sm_to_i16(I(sv->vibe) - 75.0);
                                                    }
                                                }
                                                sv->code = 76;
                                            }
                                        } else {
                                            sv->trim = sm_to_i16(I(sv->vibe) - 77.0);
                                        }
                                        sv->valve = sm_to_f32(F(sv->flow) / 3.0);
                                    }
                                }
                            } else {
                                if (sv->hot && I(sv->vibe) < -50.0) {
                                    sv->level = sm_to_u8(I(sv->level) + 1.0);
                                }
                            }
                        }
                    }
                    if (F(sv->lox) > 40.0 && sv->cold) {
                        if (I(sv->thrust) < 6000.0) {
                            sv->vote = 30;
                            if (sv->wet) {
                                if (F(sv->lox) < 10.0 && I(sv->command) < 128.0) {
                                    if (I(sv->command) >= 64.0) {
                                        if (I(sv->bus) > 25000.0) {
                                            if (F(sv->fuel) < 20.0) {
                                                if (F(sv->flow) < 2.0) {
                                                    if (D(sv->chamber) > 50.0) {
                                                        sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                    }
                                                } else {
                                                    sv->open = sv->hot || sv->armed;
                                                    if (I(sv->thrust) >= 2000.0) {
                                                        sv->vote = 33;
                                                        sv->vote = 34;
                                                    } else {
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                        sv->code = 86;
                                                    }
                                                }
                                                if (I(sv->mode) > 1.0) {
                                                    sv->valve = sm_to_f32(F(sv->flow) / 5.0);
                                                } else {
                                                    sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                    sv->code = 89;
                                                }
                                            }
                                        }
                                        if (I(sv->mode) != 3.0) {
                                            if (I(sv->command) > 128.0 || !sv->wet) {
                                                if (I(sv->vibe) >= 200.0 && F(sv->lox) > 30.0) {
                                                    if (F(sv->lox) >= 40.0 && sv->wet) {
                                                        sv->trim = sm_to_i16(I(sv->vibe) - 90.0);
                                                    } else {
                                                        sv->open = sv->hot || sv->armed;
                                                    }
                                                } else {
                                                    if (I(sv->temp) >= 100.0 || sv->hot) {
                                                        sv->level = sm_to_u8(I(sv->level) + 1.0);
                                                    } else {
                                                        sv->vote = 43;
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                    }
                                                }
                                            }
                                        }
                                    } else {
                                        if (I(sv->vibe) >= -50.0) {
                                            if (D(sv->chamber) >= 80.0 && !sv->armed) {
                                                sv->vote = 45;
                                                if (I(sv->vibe) < 200.0) {
                                                    sv->trim = sm_to_i16(I(sv->vibe) - 96.0);
                                                } else {
                                                    sv->valve = sm_to_f32(F(sv->flow) / 8.0);
                                                    sv->vote = 48;
                                                }
                                            } else {
                                                if (I(sv->speed) >= 12000.0) {
                                                    if (I(sv->thrust) >= 8000.0) {
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                    } else {
                                                        sv->open = sv->hot || sv->armed;
                                                    }
                                                    sv->code = 101;
                                                } else {
                                                    sv->trim = sm_to_i16(I(sv->vibe) - 102.0);
                                                }
                                            }
                                        } else {
                                            sv->valve = sm_to_f32(F(sv->flow) / 7.0);
                                            sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                        }
                                    }
                                    if (I(sv->thrust) < 8000.0) {
                                        if (F(sv->flow) > 4.0) {
                                            if (sv->armed) {
                                                if (F(sv->lox) < 50.0) {
                                                    if (F(sv->flow) > 6.0) {
                                                        sv->code = 105;
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                    } else {
                                                        sv->trim = sm_to_i16(I(sv->vibe) - 107.0);
                                                    }
                                                }
                                                if (D(sv->chamber) > 80.0) {
                                                    sv->vote = -42;
                                                }
                                            } else {
                                                sv->open = sv->hot || sv->armed;
                                            }
                                        }
                                        if (I(sv->thrust) >= 2000.0 || I(sv->mode) == 2.0) {
                                            if (F(sv->fuel) >= 50.0 || I(sv->mode) == 3.0) {
                                                if (I(sv->bus) < 23000.0) {
                                                    sv->vote = -40;
                                                } else {
                                                    sv->trim = sm_to_i16(I(sv->vibe) - 111.0);
                                                    sv->vote = -38;
                                                }
                                                if (F(sv->lox) >= 20.0) {
                                                    if (sv->cold && I(sv->vibe) < 50.0) {
                                                        sv->valve = sm_to_f32(F(sv->flow) / 3.0);
                                                    } else {
                                                        sv->valve = sm_to_f32(F(sv->flow) / 4.0);
                                                    }
                                                } else {
                                                    if (!sv->cold) {
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                        sv->code = 116;
                                                    } else {
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                    }
                                                    if (I(sv->mode) != 3.0) {
                                                        sv->code = 118;
                                                    }
                                                }
                                            }
                                        } else {
                                            if (I(sv->thrust) >= 2000.0 && sv->wet) {
                                                if (F(sv->lox) < 40.0) {
                                                    if (sv->hot) {
                                                        sv->vote = -31;
                                                    }
                                                } else {
                                                    if (I(sv->bus) < 27000.0) {
                                                        sv->code = 120;
                                                    } else {
                                                        sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                                                        sv->open = sv->hot || sv->armed;
                                                    }
                                                }
                                            }
                                        }
                                    }
                                } else {
                                    sv->trim = sm_to_i16(I(sv->vibe) - 123.0);
                                    sv->open = sv->hot || sv->armed;
                                }
                            } else {
                                sv->open = sv->hot || sv->armed;
                            }
                        } else {
                            sv->warnings = sm_to_u8(I(sv->warnings) + 1.0);
                            sv->code = 127;
                        }
                    } else {
                        sv->level = sm_to_u8(I(sv->level) + 1.0);
                    }
                } else {
                    sv->valve = sm_to_f32(F(sv->flow) / 5.0);
                }
            } else {
                sv->code = 130;
            }
        } else {
            if (D(sv->chamber) < 80.0) {
                if (F(sv->flow) > 8.0) {
                    sv->trim = sm_to_i16(I(sv->vibe) - 131.0);
                }
            }
        }
    }
    sv->spark = I(sv->code) > 65.0 && I(sv->level) > 20.0;
    sv->alarm = I(sv->warnings) > 100.0 || I(sv->vote) < -40.0;
    if (I(sv->level) > 200.0)
        sv->level = 0;
    if (I(sv->warnings) > 200.0)
        sv->warnings = 0;
}

void decide_f64_step(DecideF64 *m, DecideSv *sv)
{
    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    step(sv);
    frame_end(&m->frame, 0);
}
