// SPDX-License-Identifier: Apache-2.0
// Writes the dictionary of a .net as JSON, as a C header, as a Python module and as XTCE.  Each is complete: a receiver needs no other file.
#include "compiler/report/dictionary.h"

#include "compiler/sema/program.h"

// Returns the name of the file with _ for every character that one of the forms could misread.
static const char *name_of(const Network *net, const Buf *out)
{
    char *name = arena_alloc(out->arena, net->name->len + 1);

    for (size_t i = 0; i <= net->name->len; i++) {
        const char c = i < net->name->len ? net->name->text[i] : '\0';
        name[i] = c == '\0' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ? c : '_';
    }
    return name;
}

// Bytes from the start of a message to its field i.
static uint32_t field_offset(const NetChannel *c, size_t i)
{
    uint32_t at = NET_HEADER;

    for (size_t k = 0; k < i; k++)
        at += sm_type_info[c->field.at[k].element->type].bytes;
    return at;
}

static unsigned bytes_of(const NetField *f) { return sm_type_info[f->element->type].bytes; }
static bool is_float(SmType t) { return t == SM_F32 || t == SM_F64; }
static bool is_signed(SmType t) { return t == SM_I8 || t == SM_I16 || t == SM_I32 || t == SM_I64; }

// Returns a number as text that every language reads back exactly.
static const char *number_text(const Buf *out, SmF64 x) { return const_text(out->arena, x); }

static const char *link_of(const NetChannel *c) { return net_is_tcp(c) ? "tcp" : "udp"; }
// Returns which side of a channel waits for the other one.  The dictionary has the address of the side that waits.
static const char *listener_of(const NetChannel *c) { return net_listens(c) == c->is_send ? "sender" : "receiver"; }

// ---- JSON ----

static void write_json_field(const NetChannel *c, size_t i, Buf *out)
{
    const NetField *f = &c->field.at[i];

    buf_printf(out, "%s\n    {\"name\":\"%s\",\"type\":\"%s\",\"offset\":%lu,\"bytes\":%u", i ? "," : "", f->element->name->text,
               sm_type_info[f->element->type].spelling, (unsigned long)field_offset(c, i), bytes_of(f));
    if (f->element->range) {
        buf_printf(out, ",\"least\":%s", number_text(out, f->element->range->lo));
        buf_printf(out, ",\"most\":%s", number_text(out, f->element->range->hi));
    }
    buf_str(out, "}");
}

static void write_json_message(const NetChannel *c, Buf *out)
{
    buf_printf(out, "\n  {\"name\":\"%s\",\"direction\":\"%s\",\"link\":\"%s\",\"listens\":\"%s\",\"address\":\"%u.%u.%u.%u\",\"port\":%u,",
               c->name->text,
               c->is_send ? "send" : "receive", link_of(c), listener_of(c), c->ip[0], c->ip[1], c->ip[2], c->ip[3], (unsigned)c->port);
    buf_printf(out, "\"period_ns\":%llu,\"timeout_ns\":%llu,", (unsigned long long)c->period, (unsigned long long)c->timeout);
    buf_printf(out, "\"hash\":%lu,\"bytes\":%lu,\"sealed\":%s,\"fields\":[", (unsigned long)c->hash, (unsigned long)c->size,
               c->key ? "true" : "false");
    for (size_t i = 0; i < c->field.n; i++)
        write_json_field(c, i, out);
    buf_str(out, "]}");
}

void dictionary_write_json(const Network *net, Buf *out)
{
    buf_printf(out, "{\"smc-dictionary\":1,\"name\":\"%s\",\"magic\":19795,\"version\":1,\"messages\":[", name_of(net, out));
    for (size_t i = 0; i < net->channel.n; i++) {
        if (i)
            buf_char(out, ',');
        write_json_message(net->channel.at[i], out);
    }
    buf_str(out, "\n]}\n");
}

// ---- C ----

// The functions that every message uses.
static const char c_support[] =
    "static inline uint64_t smc_get(const uint8_t *at, unsigned n)\n{\n    uint64_t x = 0;\n\n    while (n-- > 0)\n"
    "        x = x << 8 | at[n];\n    return x;\n}\n\n"
    "static inline void smc_put(uint8_t *at, uint64_t x, unsigned n)\n{\n    for (unsigned i = 0; i < n; i++)\n"
    "        at[i] = (uint8_t)(x >> 8 * i);\n}\n\n"
    "static inline uint32_t smc_crc32(const uint8_t *at, size_t n)\n{\n    uint32_t crc = 0xFFFFFFFFu;\n\n    while (n-- > 0) {\n"
    "        crc ^= *at++;\n        for (int i = 0; i < 8; i++)\n            crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);\n    }\n"
    "    return crc ^ 0xFFFFFFFFu;\n}\n\n"
    "// 0: the frame is that of the message.  Else the cause for which it is refused.\n"
    "static inline int smc_check(const uint8_t *at, size_t n, size_t bytes, uint32_t hash, int sealed)\n{\n    if (n != bytes)\n"
    "        return n < bytes ? SMC_SHORT : SMC_LONG;\n    if (at[0] != 0x53 || at[1] != 0x4D || at[2] != 1 || at[3] != sealed ||\n"
    "        smc_get(at + n - 4, 4) != smc_crc32(at, n - 4))\n        return SMC_DAMAGED;\n"
    "    return smc_get(at + 4, 4) == hash ? SMC_OK : SMC_HASH;\n}\n";

static const char *c_type(SmType t)
{
    static const char *const names[] = {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) #ctype,
#include "stdlib/types.def"
#undef SM_TYPE
    };

    return t == SM_F64 ? "double" : names[t];
}

// Says how a message travels, and on which side of a connection a receiver or sender of the dictionary is.
static void write_c_link(const NetChannel *c, const char *type, Buf *out)
{
    if (net_is_tcp(c))
        buf_printf(out, "// Over TCP: messages follow each other without gaps.  Receive and decode %s_BYTES bytes at a time, and close the\n"
                        "// connection if they are refused as damaged or for their hash.  The %s listens at %s_PORT.\n", type, listener_of(c), type);
    else
        buf_str(out, "// Over UDP: each packet is one message.\n");
}

static void write_c_struct(const NetChannel *c, const char *type, Buf *out)
{
    buf_printf(out, "\n// ---- %s: %lu bytes%s ----\n\n", c->name->text, (unsigned long)c->size,
               c->key ? ", sealed with a key: only the owner of the key can verify or send it" : "");
    write_c_link(c, type, out);
    buf_printf(out, "enum { %s_BYTES = %lu, %s_PORT = %u, %s_TCP = %d };\n#define %s_HASH 0x%08lxu\n\n", type, (unsigned long)c->size, type,
               (unsigned)c->port, type, net_is_tcp(c), type, (unsigned long)c->hash);
    buf_printf(out, "typedef struct %s {\n    uint32_t run, number;\n", type);
    for (size_t i = 0; i < c->field.n; i++) {
        const NetField *f = &c->field.at[i];
        buf_printf(out, "    %s v_%s;", c_type(f->element->type), f->element->name->text);
        if (f->element->range) {
            buf_printf(out, "        // %s", number_text(out, f->element->range->lo));
            buf_printf(out, " to %s", number_text(out, f->element->range->hi));
        }
        buf_char(out, '\n');
    }
    buf_printf(out, "} %s;\n", type);
}

// Writes the check of one decoded field against its declared range.
static void write_c_range(const char *name, const Range *r, Buf *out)
{
    buf_printf(out, "    if (!((double)m->v_%s >= %s", name, number_text(out, r->lo));
    buf_printf(out, " && (double)m->v_%s <= %s))\n        return SMC_RANGE;\n", name, number_text(out, r->hi));
}

static void write_c_decode(const NetChannel *c, const char *type, Buf *out)
{
    buf_printf(out, "\n// Reads n bytes.  Any result but SMC_OK: the message is refused, and *m is not usable.\n"
                    "static inline int %s_decode(const uint8_t *at, size_t n, %s *m)\n{\n"
                    "    int cause = smc_check(at, n, %s_BYTES, %s_HASH, %d);\n\n    if (cause != SMC_OK)\n        return cause;\n"
                    "    m->run = (uint32_t)smc_get(at + 8, 4);\n    m->number = (uint32_t)smc_get(at + 12, 4);\n",
               type, type, type, type, c->key != NULL);
    for (size_t i = 0; i < c->field.n; i++) {
        const SmType t = c->field.at[i].element->type;
        const char *name = c->field.at[i].element->name->text;
        const unsigned long at = (unsigned long)field_offset(c, i);
        const unsigned n = bytes_of(&c->field.at[i]);
        if (is_float(t))
            buf_printf(out, "    {\n        uint%u_t bits = (uint%u_t)smc_get(at + %lu, %u);\n        memcpy(&m->v_%s, &bits, %u);\n    }\n"
                            "    if (!(m->v_%s - m->v_%s == 0))\n        return SMC_NAN;\n", 8 * n, 8 * n, at, n, name, n, name, name);
        else if (is_signed(t))
            buf_printf(out, "    m->v_%s = (%s)(uint%u_t)smc_get(at + %lu, %u);\n", name, c_type(t), 8 * n, at, n);
        else
            buf_printf(out, "    m->v_%s = (%s)smc_get(at + %lu, %u);\n", name, c_type(t), at, n);
        if (t == SM_BOOL)
            buf_printf(out, "    if (m->v_%s > 1)\n        return SMC_NAN;\n", name);
        if (c->field.at[i].element->range)
            write_c_range(name, c->field.at[i].element->range, out);
    }
    buf_str(out, "    return SMC_OK;\n}\n");
}

static void write_c_encode(const NetChannel *c, const char *type, Buf *out)
{
    buf_printf(out, "\n// Writes %s_BYTES bytes.  The number grows by 1 in each message of a run of the sender.\n"
                    "static inline void %s_encode(const %s *m, uint8_t *at)\n{\n    smc_put(at, 0x4D53, 2);\n    smc_put(at + 2, 1, 2);\n"
                    "    smc_put(at + 4, %s_HASH, 4);\n    smc_put(at + 8, m->run, 4);\n    smc_put(at + 12, m->number, 4);\n", type, type,
               type, type);
    for (size_t i = 0; i < c->field.n; i++) {
        const char *name = c->field.at[i].element->name->text;
        const unsigned long at = (unsigned long)field_offset(c, i);
        const unsigned n = bytes_of(&c->field.at[i]);
        if (is_float(c->field.at[i].element->type))
            buf_printf(out, "    {\n        uint%u_t bits;\n        memcpy(&bits, &m->v_%s, %u);\n        smc_put(at + %lu, bits, %u);\n    }\n",
                       8 * n, name, n, at, n);
        else
            buf_printf(out, "    smc_put(at + %lu, (uint64_t)m->v_%s, %u);\n", at, name, n);
    }
    buf_printf(out, "    smc_put(at + %lu, smc_crc32(at, %lu), 4);\n}\n", (unsigned long)c->size - 4, (unsigned long)c->size - 4);
}

void dictionary_write_c(const Network *net, Buf *out)
{
    buf_printf(out, "// The messages of %s.net, for programs on other computers.  Generated by smc from %s.net: edit that, not this file.\n"
                    "// It needs no other file of smc.  A message has a fixed size; all numbers are little-endian.\n#pragma once\n\n"
                    "#include <stddef.h>\n#include <stdint.h>\n#include <string.h>\n\n#ifndef SMC_DICTIONARY_SUPPORT\n"
                    "#define SMC_DICTIONARY_SUPPORT\n\n"
                    "enum { SMC_OK, SMC_SHORT, SMC_LONG, SMC_DAMAGED, SMC_HASH, SMC_NAN, SMC_RANGE };\n\n%s#endif\n",
               name_of(net, out), name_of(net, out), c_support);
    for (size_t i = 0; i < net->channel.n; i++) {
        const NetChannel *c = net->channel.at[i];
        const char *type = format_in(out->arena, "smc_%s", c->name->text);
        write_c_struct(c, type, out);
        write_c_decode(c, type, out);
        if (!c->key)
            write_c_encode(c, type, out);
    }
}

// ---- Python ----

static const char python_support[] =
    "import math\nimport struct\nimport zlib\n\n\nclass Refused(ValueError):\n    \"\"\"The bytes are not a message that a receiver accepts.\"\"\"\n\n\n"
    "def decode(name, data):\n    \"\"\"Returns (run, number, values by name) of a message; raises Refused with the cause.\"\"\"\n"
    "    m = MESSAGES[name]\n    if len(data) != m['bytes']:\n        raise Refused('short' if len(data) < m['bytes'] else 'long')\n"
    "    magic, version, sealed, hash_, run, number = struct.unpack_from('<HBBIII', data)\n"
    "    if (magic, version, sealed) != (0x4D53, 1, m['sealed']) or struct.unpack('<I', data[-4:])[0] != zlib.crc32(data[:-4]):\n"
    "        raise Refused('damaged')\n    if hash_ != m['hash']:\n        raise Refused('hash')\n"
    "    values = struct.unpack_from(m['format'], data, 16)\n    for x, letter in zip(values, m['format'][1:]):\n"
    "        if letter in 'fd' and not math.isfinite(x):\n            raise Refused('nan')\n"
    "    result = dict(zip(m['names'], values))\n    for key in m['bools']:\n        if result[key] > 1:\n            raise Refused('nan')\n"
    "        result[key] = bool(result[key])\n    for key, (least, most) in m['ranges'].items():\n"
    "        if not least <= result[key] <= most:\n            raise Refused('range')\n    return run, number, result\n\n\n"
    "def encode(name, run, number, values):\n    \"\"\"Returns the bytes of a message that is not sealed.\"\"\"\n    m = MESSAGES[name]\n"
    "    if m['sealed']:\n        raise ValueError('only the owner of the key can send it')\n"
    "    body = struct.pack('<HBBIII', 0x4D53, 1, 0, m['hash'], run, number)\n"
    "    body += struct.pack(m['format'], *(values[key] for key in m['names']))\n    return body + struct.pack('<I', zlib.crc32(body))\n";

static void write_python_message(const NetChannel *c, Buf *out)
{
    static const char letters[] = "bhiqBHIQfdB";          // by SmType
    bool first = true;

    buf_printf(out, "    '%s': {\n        'direction': '%s', 'link': '%s', 'listens': '%s', 'address': '%u.%u.%u.%u', 'port': %u,\n"
                    "        'hash': 0x%08lx, 'bytes': %lu, 'sealed': %d,\n        'format': '<", c->name->text,
               c->is_send ? "send" : "receive", link_of(c), listener_of(c), c->ip[0], c->ip[1], c->ip[2], c->ip[3],
               (unsigned)c->port, (unsigned long)c->hash, (unsigned long)c->size, c->key != NULL);
    for (size_t i = 0; i < c->field.n; i++)
        buf_char(out, letters[c->field.at[i].element->type]);
    buf_str(out, "',\n        'names': [");
    for (size_t i = 0; i < c->field.n; i++)
        buf_printf(out, "%s'%s'", i ? ", " : "", c->field.at[i].element->name->text);
    buf_str(out, "],\n        'bools': [");
    for (size_t i = 0; i < c->field.n; i++)
        if (c->field.at[i].element->type == SM_BOOL) {
            buf_printf(out, "%s'%s'", first ? "" : ", ", c->field.at[i].element->name->text);
            first = false;
        }
    buf_str(out, "],\n        'ranges': {");
    first = true;
    for (size_t i = 0; i < c->field.n; i++) {
        const Range *r = c->field.at[i].element->range;
        if (!r)
            continue;
        buf_printf(out, "%s'%s': (%s", first ? "" : ", ", c->field.at[i].element->name->text, number_text(out, r->lo));
        buf_printf(out, ", %s)", number_text(out, r->hi));
        first = false;
    }
    buf_str(out, "},\n    },\n");
}

void dictionary_write_python(const Network *net, Buf *out)
{
    buf_printf(out, "# The messages of %s.net.  Generated by smc from %s.net: edit that, not this file.\n%s\n\nMESSAGES = {\n",
               name_of(net, out), name_of(net, out), python_support);
    for (size_t i = 0; i < net->channel.n; i++)
        write_python_message(net->channel.at[i], out);
    buf_str(out, "}\n");
}

// ---- XTCE ----

static void write_xtce_type(const NetField *f, const char *message, Buf *out)
{
    const SmType t = f->element->type;
    const unsigned bits = 8 * bytes_of(f);
    const char *name = f->element->name->text, *order = bits > 8 ? " byteOrder=\"leastSignificantByteFirst\"" : "";

    if (is_float(t))
        buf_printf(out, "      <FloatParameterType name=\"%s_%s_t\" sizeInBits=\"%u\"><FloatDataEncoding sizeInBits=\"%u\" encoding=\"IEEE754_1985\"%s/>"
                        "</FloatParameterType>\n", message, name, bits, bits, order);
    else if (t == SM_BOOL)
        buf_printf(out, "      <BooleanParameterType name=\"%s_%s_t\"><IntegerDataEncoding sizeInBits=\"8\" encoding=\"unsigned\"/>"
                        "</BooleanParameterType>\n", message, name);
    else
        buf_printf(out, "      <IntegerParameterType name=\"%s_%s_t\" sizeInBits=\"%u\" signed=\"%s\"><IntegerDataEncoding sizeInBits=\"%u\" encoding=\"%s\"%s/>"
                        "</IntegerParameterType>\n", message, name, bits, is_signed(t) ? "true" : "false", bits,
                   is_signed(t) ? "twosComplement" : "unsigned", order);
}

static const struct { const char *name; unsigned bits; } xtce_header[] = {
    {"magic", 16}, {"version", 8}, {"sealed", 8}, {"hash", 32}, {"run", 32}, {"number", 32}, {"crc", 32}};
enum { XTCE_HEADER = sizeof xtce_header / sizeof *xtce_header };

// The message as an XTCE packet: its link, its fields in order, and the hash in the header by which a receiver recognizes it.
static void write_xtce_container(const NetChannel *c, Buf *out)
{
    buf_printf(out, "      <SequenceContainer name=\"%s\">\n        <AncillaryDataSet>\n", c->name->text);
    buf_printf(out, "          <AncillaryData name=\"link\">%s</AncillaryData>\n          <AncillaryData name=\"listens\">%s</AncillaryData>\n",
               link_of(c), listener_of(c));
    buf_printf(out, "          <AncillaryData name=\"address\">%u.%u.%u.%u:%u</AncillaryData>\n        </AncillaryDataSet>\n        <EntryList>\n",
               c->ip[0], c->ip[1], c->ip[2], c->ip[3], (unsigned)c->port);
    for (size_t i = 0; i < c->field.n; i++)
        buf_printf(out, "          <ParameterRefEntry parameterRef=\"%s_%s\"/>\n", c->name->text, c->field.at[i].element->name->text);
    if (c->key)
        buf_str(out, "          <ParameterRefEntry parameterRef=\"code\"/>\n");
    buf_printf(out, "          <ParameterRefEntry parameterRef=\"crc\"/>\n        </EntryList>\n        <BaseContainer containerRef=\"header\">\n"
                    "          <RestrictionCriteria><Comparison parameterRef=\"hash\" value=\"%lu\"/></RestrictionCriteria>\n"
                    "        </BaseContainer>\n      </SequenceContainer>\n", (unsigned long)c->hash);
}

void dictionary_write_xtce(const Network *net, Buf *out)
{
    buf_printf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Generated by smc from %s.net: edit that, not this file. -->\n"
                    "<SpaceSystem name=\"%s\" xmlns=\"http://www.omg.org/spec/XTCE/20180204\">\n  <TelemetryMetaData>\n    <ParameterTypeSet>\n",
               name_of(net, out), name_of(net, out));
    for (int i = 0; i < XTCE_HEADER; i++)
        buf_printf(out, "      <IntegerParameterType name=\"%s_t\" sizeInBits=\"%u\" signed=\"false\"><IntegerDataEncoding sizeInBits=\"%u\" encoding=\"unsigned\"%s/>"
                        "</IntegerParameterType>\n", xtce_header[i].name, xtce_header[i].bits, xtce_header[i].bits,
                   xtce_header[i].bits > 8 ? " byteOrder=\"leastSignificantByteFirst\"" : "");
    buf_str(out, "      <BinaryParameterType name=\"code_t\"><BinaryDataEncoding><SizeInBits><FixedValue>128</FixedValue></SizeInBits></BinaryDataEncoding>"
                 "</BinaryParameterType>\n");
    for (size_t i = 0; i < net->channel.n; i++)
        for (size_t k = 0; k < net->channel.at[i]->field.n; k++)
            write_xtce_type(&net->channel.at[i]->field.at[k], net->channel.at[i]->name->text, out);
    buf_str(out, "    </ParameterTypeSet>\n    <ParameterSet>\n");
    for (int i = 0; i < XTCE_HEADER; i++)
        buf_printf(out, "      <Parameter name=\"%s\" parameterTypeRef=\"%s_t\"/>\n", xtce_header[i].name, xtce_header[i].name);
    buf_str(out, "      <Parameter name=\"code\" parameterTypeRef=\"code_t\"/>\n");
    for (size_t i = 0; i < net->channel.n; i++)
        for (size_t k = 0; k < net->channel.at[i]->field.n; k++) {
            const char *m = net->channel.at[i]->name->text, *n = net->channel.at[i]->field.at[k].element->name->text;
            buf_printf(out, "      <Parameter name=\"%s_%s\" parameterTypeRef=\"%s_%s_t\"/>\n", m, n, m, n);
        }
    buf_str(out, "    </ParameterSet>\n    <ContainerSet>\n      <SequenceContainer name=\"header\" abstract=\"true\">\n        <EntryList>\n");
    for (int i = 0; i < XTCE_HEADER - 1; i++)
        buf_printf(out, "          <ParameterRefEntry parameterRef=\"%s\"/>\n", xtce_header[i].name);
    buf_str(out, "        </EntryList>\n      </SequenceContainer>\n");
    for (size_t i = 0; i < net->channel.n; i++)
        write_xtce_container(net->channel.at[i], out);
    buf_str(out, "    </ContainerSet>\n  </TelemetryMetaData>\n</SpaceSystem>\n");
}
