spec 1.21   What users of other languages write is reported once, with what to write instead: a block is reported at its first word only.

-- app.sm --
[state_vector]
U64  time   @alias G
U32  state  @alias S
F64  x
bool valve
[Hold]
.step
    void update() {                 #! E0329 there are no functions: put the statements below .step
        x = 1;
        digitalWrite(LED, HIGH);
    }
    function y = half(x)            #! E0329 one of values is a line in [define]
        y = x / 2;
    end
    lambda x: x                     #! E0329 write a function in [define]
    class Tank:                     #! E0329 there are no classes
        level = 0
    do {                            #! E0329 there are no loops
        x = x + 1;
    } while (x < 5);
    try:                            #! E0329 nothing raises an exception
        x = 1
    except:
        x = 2
    x > 1: valve = true
    catch {                         #! E0329 nothing raises an exception
        x = 2
    }
    x > 2: valve = true
    finally:                        #! E0329 nothing raises an exception
        x = 3
    x > 3: valve = true
    except:                         #! E0329 nothing raises an exception
        x = 3
    global x                        #! E0329 leave it out
    switch (x) {                    #! E0329 write it as if x == 1
        case 1:
            valve = HIGH;
            break;
        default:
            valve = LOW;
    }
    switch x                        #! E0329 write it as if x == 1
    case 1
        valve = HIGH;
    otherwise
        valve = LOW;
    end
    for i = 1:10                    #! E0329 there are no loops
        x = x + i;
    end
    x > 5: valve = true
    char *name                      #! E0338 no variable can store a text
    int *count                      #! E0338 there are no pointers
    int samples[8];                 #! E0338 I32 samples1 = 0 and I32 samples2 = 0
    x > 9: -> Vent
[Vent]
