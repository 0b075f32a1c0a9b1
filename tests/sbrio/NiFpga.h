// SPDX-License-Identifier: Apache-2.0
// A stand-in for NI's NiFpga.h: the part of the FPGA Interface C API that psl/sbrio uses, declared as NI's help documents it.  It is not NI's
// file, and accesses no hardware.
#ifndef NIFPGA_H
#define NIFPGA_H

#include <stdint.h>

typedef uint8_t NiFpga_Bool;
typedef int32_t NiFpga_Status;
typedef uint32_t NiFpga_Session;

typedef enum { NiFpga_OpenAttribute_NoRun = 1 } NiFpga_OpenAttribute;
typedef enum { NiFpga_CloseAttribute_NoResetIfLastSession = 1 } NiFpga_CloseAttribute;

NiFpga_Status NiFpga_Initialize(void);
NiFpga_Status NiFpga_Finalize(void);
NiFpga_Status NiFpga_Open(const char *bitfile, const char *signature, const char *resource, uint32_t attribute, NiFpga_Session *session);
NiFpga_Status NiFpga_Close(NiFpga_Session session, uint32_t attribute);
NiFpga_Status NiFpga_Run(NiFpga_Session session, uint32_t attribute);

#define NIFPGA_ACCESS(name, c) \
    NiFpga_Status NiFpga_Read##name(NiFpga_Session session, uint32_t indicator, c *value); \
    NiFpga_Status NiFpga_Write##name(NiFpga_Session session, uint32_t control, c value);
NIFPGA_ACCESS(Bool, NiFpga_Bool)
NIFPGA_ACCESS(I8, int8_t)
NIFPGA_ACCESS(U8, uint8_t)
NIFPGA_ACCESS(I16, int16_t)
NIFPGA_ACCESS(U16, uint16_t)
NIFPGA_ACCESS(I32, int32_t)
NIFPGA_ACCESS(U32, uint32_t)
NIFPGA_ACCESS(I64, int64_t)
NIFPGA_ACCESS(U64, uint64_t)
NIFPGA_ACCESS(Sgl, float)
NIFPGA_ACCESS(Dbl, double)
#undef NIFPGA_ACCESS

#endif
