# Expressions with units, each judged by hand. A mark is a certain mistake; a line without one is good, or cannot be judged.
warn no-all units
-- app.sm --
[state_vector]
U64  G
U32  S
F64  alt      @unit m
F64  altFt    @unit ft
F64  altKm    @unit km
F64  v        @unit m/s
F64  vFt      @unit ft/s
F64  vKmh     @unit km/h
F64  a        @unit m/s^2
F64  aG       @unit gn
F64  aGram    @unit g
F64  p        @unit bar
F64  pPsi     @unit psi
F64  pPa      @unit Pa
F64  pMpa     @unit MPa
F64  pMilli   @unit mPa
F64  pHpa     @unit hPa
F64  tC       @unit degC
F64  tC2      @unit degC
F64  tF       @unit degF
F64  tK       @unit K
F64  rise     @unit K
F64  riseRate @unit K/s
F64  thr      @unit percent
F64  ratio    @unit 1
F64  f        @unit N
F64  fLbf     @unit lbf
F64  fKn      @unit kN
F64  kn       @unit kn
F64  m        @unit kg
F64  mLb      @unit lb
F64  flow     @unit kg/s
F64  rho      @unit kg/m^3
F64  area     @unit m^2
F64  vol      @unit L
F64  volM     @unit m^3
F64  pitch    @unit deg
F64  roll     @unit rad
F64  gyro     @unit deg/s
F64  gyroRad  @unit rad/s
F64  spin     @unit rpm
F64  freq     @unit Hz
F64  u        @unit V
F64  uMv      @unit mV
F64  i        @unit A
F64  r        @unit ohm
F64  power    @unit W
F64  energy   @unit J
F64  torque   @unit N*m
F64  charge   @unit A*h
F64  isp      @unit s
F64  imp      @unit N*s
F64  cp       @unit J/(kg*K)
F64  gasR     @unit J/kg/K
F64  noise    @unit V/Hz^0.5
F64  stiff    @unit N/mm
F64  plain
bool on
[local]
F64  dt     = 0.02   @unit s
F64  dtMs   = 20     @unit ms
F64  delay  = 5 s    @unit ms
F64  delayS = 5 s    @unit s           #! W0448 'delayS' has the unit s, but '5 s' has the unit ms
F64  wait   = 5000   @unit ms
F64  zero   = 273.15 @unit K @read_only
F64  g0     = 9.80665 @unit m/s^2
F64  pLimit = 55     @unit bar
F64  twice  = pLimit * 2 @unit bar
F64  other  = pLimit @unit psi         #! W0448 1 bar is 14.5038 psi
F64  free   = pLimit
F64  gain   = 0.3
F64  e      = 0
[define]
pi       = 3.14159265358979
psiToBar = 0.0689476 @unit bar/psi
high     = p > 50
climb    = v * 3
inMetres = altFt * 0.3048 @unit m
badDef   = altFt @unit m               #! W0448 'badDef' has the unit m, but 'altFt' has the unit ft
again    = badDef @unit m
[Table] @safe
.step
# ---- lengths, numbers and conversions ----
    alt = 100
    alt = altFt                        #! W0448 'alt' has the unit m, but 'altFt' has the unit ft
    alt = altFt * 0.3048
    alt = 0.3048 * altFt
    alt = altFt / 3.28084
    alt = altFt / 3.28
    alt = altFt * 0.305
    alt = altFt * 3.28084              #! W0448 1 ft is 0.3048 m
    alt = altFt / 0.3048               #! W0448
    alt = altFt * 2                    #! W0448
    alt = -altFt                       #! W0448
    alt = altFt + 100                  #! W0448
    alt = 2 * alt
    alt = alt / 2 + 10
    alt = altKm * 1000
    alt = altKm                        #! W0448 1 km is 1000 m
    alt = altKm * 12 * 25.4            # a number that smc cannot explain
    alt = plain
    alt = plain * altFt
    alt = plain + altFt                #! W0448 'plain + altFt' has the unit ft
    plain = altFt
    plain = alt + altFt                #! W0448
    plain = alt + altFt * 0.3048
    plain = alt + altKm * 1000
    plain = alt * 0.001 + altKm
    plain = 0.9 * alt + 0.1 * alt
    plain = 0.98 * alt + 0.02 * altFt  #! W0448
    plain = 0.3048 * altFt + alt
    plain = (alt + altFt) / 2          #! W0448
    plain = gain * alt + gain * altFt
    plain = alt - altFt                #! W0448
    plain = alt * altFt
    area = alt * alt
    area = alt * altFt                 #! W0448 1 m*ft is 0.3048 m^2
    area = alt                         #! W0448 they measure different things
    plain = alt + area                 #! W0448
    alt = area / alt
    alt = sqrt(area)
    alt = pow(area, 0.5)
    area = pow(alt, 2)
    area = pow(altFt, 2)               #! W0448
    alt = sqrt(alt)                    #! W0448
    alt = inMetres
    altFt = inMetres                   #! W0448
    altFt = again                      #! W0448
# ---- comparisons ----
    plain = alt > 300
    plain = alt > altFt                #! W0448
    plain = alt == altFt               #! W0448
    plain = 100 < alt < 200
    plain = 100 < alt < altFt          #! W0448
    plain = altFt > alt > 100 and v > 5        #! W0448
    plain = alt > 300 == on
    plain = (alt > 300) + 5
    plain = alt * on
    alt = alt * (v > 3)
    alt = altFt * (v > 3)              #! W0448
    alt = v * (v > 3)                  #! W0448
    plain = not alt
    plain = alt and altFt
    alt > v: plain = 1                 #! W0448
    S == 3: plain = 2
# ---- times ----
    plain = T > 5000
    plain = T > 5 s
    plain = T > delay
    plain = T > wait
    plain = T > dt                     #! W0448 1 s is 1000 ms
    plain = G - T > delay
    plain = T > alt                    #! W0448
    plain = p > 5 s                    #! W0448 'p' has the unit bar, but '5 s' has the unit ms
    plain = T / 1000 > dt
    plain = T > dt * 1000
    plain = T * 1000 > dt              #! W0448
    plain = T + 2 s > delay
    dt = T                             #! W0448
    dt = T / 1000
    dt = T * 0.001
    dtMs = T
    dtMs = 1 / freq                    #! W0448 1 1/Hz is 1000 ms
    dt = 1 / freq
    freq = 1 / dtMs                    #! W0448
    freq = 1000 / dtMs
# ---- motion ----
    alt = alt + v * dt
    alt = alt + v * dtMs               #! W0448 1 m*ms/s is 0.001 m
    alt = alt + v * dtMs / 1000
    alt = alt + v * 0.02               # 0.02 can be a time
    alt = alt + v * 20 ms              #! W0448
    alt = alt + v                      #! W0448
    alt = alt + climb
    alt = alt + vFt * dt               #! W0448
    alt = alt + vFt * dt * 0.3048
    alt = alt + a * dt * dt / 2
    alt = alt + 0.5 * a * dt * dt
    alt = alt + 0.5 * a * dt           # 0.5 can be a time
    alt = alt + a * dt                 #! W0448
    v = v + a * dt
    v = v + (a - g0) * dt
    v = v + (a - 9.81) * dt
    v = v + aG * dt                    #! W0448 1 gn*s is 9.80665 m/s
    v = v + aG * 9.81 * dt
    v = rate(alt, 5)
    v = rate(altFt, 5)                 #! W0448
    vFt = rate(altFt, 5)
    a = rate(v, 3)
    a = rate(alt, 3)                   #! W0448
    vKmh = v                           #! W0448 1 m/s is 3.6 km/h
    vKmh = v * 3.6
    vKmh = v / 3.6                     #! W0448
    vKmh = kn * 1.852
    v = sqrt(2 * a * alt)
    v = sqrt(2 * 9.81 * alt)
    v = sqrt(alt)                      #! W0448
    v = sqrt(v * v + 2 * a * alt)
    v = sqrt(v * v + a)                #! W0448
    v = hypot(v, v)
    v = hypot(v, vFt)                  #! W0448
    a = aG                             #! W0448 1 gn is 9.80665 m/s^2
    a = aG * 9.81
    aG = a / g0 * 1
    aG = a / 9.80665
    a = aGram                          #! W0448 g is the gram
    isp = imp / (m * g0)
    isp = imp / m                      #! W0448
# ---- pressures ----
    p = pPsi                           #! W0448 1 psi is 0.0689476 bar
    p = pPsi * 0.0689476
    p = pPsi * 0.069
    p = pPsi / 14.5
    p = pPsi * 14.5                    #! W0448
    p = pPsi * psiToBar
    p = pPsi / psiToBar                #! W0448
    p = pPa / 100000
    p = pPa / 1e5 - 1.013
    p = pMpa * 10
    p = pMpa                           #! W0448
    p = pMilli                         #! W0448
    pMpa = pMilli                      #! W0448
    pHpa = p * 1000
    p = max(p, pPsi)                   #! W0448
    p = max(p, 3)
    p = min(max(p, pPsi), pLimit)      #! W0448
    p = clamp(p, 0, pPsi)              #! W0448
    p = clamp(p, 0, pLimit)
    p = roll_avg(p, 5)
    p = roll_median(pPsi, 5)           #! W0448
    p = roll_min(p, 3)
    p = median(p, abs(p), p * 2)
    p = median(p, pPsi, abs(p))        #! W0448
    p = average(p, abs(p))
    p = average(pPsi, p)               #! W0448
    p = roll_max(p, 3) - roll_range(p, 3)
    p = prev(p)
    p = prev(pPsi)                     #! W0448
    plain = held(p > pPsi, 3 steps)    #! W0448
    plain = held(p > pLimit, 3 steps)
    plain = rising(p > pPsi)           #! W0448
    plain = falling(p > pPsi)          #! W0448
    p = abs(p - pLimit)
    p = abs(p - pPsi)                  #! W0448
    p = round(p)
    p = floor(p)
    p = ceil(pPsi)                     #! W0448
    p = trunc(pPsi)                    #! W0448
    p = sign(p)
    p = sign(p) * pLimit
    p = f / area                       #! W0448 1 N/m^2 is 1e-05 bar
    p = f / area / 1e5
    pPa = f / area
    pPa = fLbf / area                  #! W0448
    pPa = rho * v * v / 2
    pPa = 0.5 * rho * v * v
    pPa = rho * g0 * alt
    pPa = rho * 9.81 * alt
    pPa = rho * gasR * tK
    alt = 44330 * (1 - pow(pHpa / 1013.25, 0.1903))
    alt = 44330 * (1 - pow(pHpa / pHpa, 0.1903))
    pHpa = 1013.25 * exp(-alt / 8434)
    pHpa = pHpa * exp(-alt / alt)
    p = pHpa * exp(-alt / alt)         #! W0448
# ---- temperatures ----
    tC = tC2
    tC = tK                            #! W0448 0 degC is 273.15 K
    tK = tC                            #! W0448 0 degC is 273.15 K
    tK = tC + 273.15
    tK = 273.15 + tC
    tK = tC + 273
    tC = tK - 273.15
    tK = tC - 273.15                   #! W0448
    tK = tC + zero
    tC = tK - zero
    tK = tC + 5                        #! W0448
    tK = tC + plain
    tC = tC + 5
    tC = tC + rise
    tC = rise + tC
    tC = tC - rise
    rise = tC - tC2
    tC = tC - tC2
    rise = tK - tC                     #! W0448
    rise = tK - 290
    plain = tC - tC2 > rise
    plain = abs(tC - tC2) > rise
    plain = tC > tK                    #! W0448
    plain = tC > 80
    plain = tC + 273.15 > tK
    plain = tC > tF                    #! W0448 0 degF is -17.7778 degC
    tF = tC * 1.8 + 32
    tF = tC * 9 / 5 + 32
    tC = (tF - 32) / 1.8
    tC = (tF - 32) * 5 / 9
    tC = tF                            #! W0448
    tF = tF + rise                     #! W0448
    tC = max(tC, tK)                   #! W0448
    tC = (tC + tC2) / 2
    tC = 0.9 * tC + 0.1 * tC2
    tC = roll_avg(tC, 5)
    rise = roll_range(tC, 5)
    riseRate = rate(tC, 5)
    riseRate = rate(tF, 5)             #! W0448
    energy = m * cp * (tC - tC2)
    energy = m * cp * rise
    energy = m * cp                    #! W0448
    tC = tC + riseRate * dt
    plain = 1 + 0.002 * (tC - 25)
# ---- angles ----
    v = v * sin(roll)
    v = v * sin(pitch)                 #! W0449 sin needs radians, but 'pitch' has the unit deg
    v = v * cos(pitch * 0.0174533)
    v = v * cos(pitch * pi / 180)
    v = v * tan(pitch / 57.3)
    v = v * tan(pitch + 2)             #! W0449
    v = v * sin(2 * pitch)             #! W0449
    plain = sin(alt)                   #! W0449
    plain = sin(alt * 0.1)
    plain = sin(2 * pi * freq * dt)
    plain = sin(ratio)
    plain = sin(90)
    plain = sin(plain * pitch)
    roll = asin(a / g0)
    roll = acos(aG)
    roll = acos(a)                     #! W0449
    roll = acos(a / 9.81)
    pitch = acos(ratio)                #! W0448 1 rad is 57.2958 deg
    pitch = acos(ratio) * 57.2958
    pitch = acos(ratio) * 180 / pi
    pitch = atan2(v, v) * 180 / 3.1416
    roll = atan2(v, vFt)               #! W0448
    roll = atan2(v, a)                 #! W0448
    roll = atan(v / v)
    roll = atan(v / vFt)               #! W0449
    plain = pitch > roll               #! W0448
    plain = pitch > 45
    pitch = pitch + gyro * dt
    pitch = pitch + gyroRad * dt       #! W0448
    roll = roll + gyro * dt            #! W0448
    roll = roll + gyro * dt * 0.01745
    gyro = gyroRad * 57.3
    v = gyroRad * alt
    v = gyro * alt                     #! W0448 1 deg*m/s is 0.0174533 m/s
    gyroRad = spin * 0.10472
    gyroRad = spin                     #! W0448
    freq = spin / 60
    freq = spin                        #! W0448
    freq = gyroRad                     # 1/s both: smc cannot tell them apart
# ---- forces, masses, electricity ----
    f = m * a
    f = m * aG                         #! W0448
    f = m * g0
    f = mLb * a                        #! W0448
    f = m                              #! W0448
    f = fLbf                           #! W0448 1 lbf is 4.44822 N
    f = fLbf * 4.448
    f = fKn * 1000
    fKn = kn                           #! W0448 they measure different things
    f = flow * v
    f = flow * isp * g0
    f = flow * isp                     #! W0448
    f = p * area                       #! W0448
    f = pPa * area
    f = stiff * alt                    #! W0448 1 N*m/mm is 1000 N
    imp = imp + f * dt
    m = m - flow * dt
    m = rho * volM
    m = rho * vol                      #! W0448
    vol = volM * 1000
    power = u * i
    power = u * u / r
    power = r * i * i
    power = u / r                      #! W0448
    u = i * r
    u = uMv / 1000
    u = uMv                            #! W0448
    i = u / 12
    energy = power * dt
    energy = power * dtMs              #! W0448
    energy = torque                    # J and N*m: smc cannot tell them apart
    charge = charge + i * dt / 3600
    charge = charge + i * dt           #! W0448
    power = torque * gyroRad
    power = torque * spin              #! W0448
    u = noise * sqrt(freq)
    u = noise * freq                   #! W0448
# ---- ratios ----
    thr = 50
    thr = ratio                        #! W0448 1 is 100 percent
    thr = ratio * 100
    ratio = thr / 100
    ratio = p / pLimit
    ratio = p / pPsi                   #! W0448 1 bar/psi is 14.5038
    thr = p / pLimit                   #! W0448
    thr = 100 * p / pLimit
    f = f * thr                        #! W0448 1 N*percent is 0.01 N
    f = f * thr / 100
    f = f * ratio
    plain = thr > 50
    plain = thr > ratio                #! W0448
    plain = 1 - ratio
    plain = p / pLimit > 0.9
    plain = pow(2, ratio)
    plain = pow(2, alt)                #! W0449 pow needs a plain number
    plain = log(p / pLimit)
    plain = log(p)
    alt = log10(alt)
    ratio = thr + ratio                #! W0448
