# SPDX-License-Identifier: Apache-2.0
# Three computers that have nothing of smc but one form of the dictionary: the Python module, the JSON, the XTCE.  Each prints the telemetry of
# the bytes in argv[1]; the first also prints the bytes of a command.
import json, struct, sys
import xml.etree.ElementTree as ElementTree
import link

data = bytes.fromhex(sys.argv[1])
run, number, values = link.decode('telemetry', data)
print('python', list(values.values()))
for damage, cause in ((data[:-1], 'short'), (data + b'0', 'long'), (data[:9] + b'x' + data[10:], 'damaged')):
    try:
        link.decode('telemetry', damage)
        print('accepted', cause)
    except link.Refused as e:
        print('refused', e)
command = dict(vent=0, throttle=0.25, trim=-7, target=1e6, total=2 ** 64 - 1)
print('command', link.encode('commands', 1, 1, command).hex())

letters = dict(I8='b', I16='h', I32='i', I64='q', U8='B', U16='H', U32='I', U64='Q', F32='f', F64='d', bool='?')
message = [m for m in json.load(open('link.json'))['messages'] if m['hash'] == struct.unpack_from('<I', data, 4)[0]][0]
print('json', [struct.unpack_from('<' + letters[f['type']], data, f['offset'])[0] for f in message['fields']])

tree = ElementTree.parse('link.xml').getroot()
x = '{http://www.omg.org/spec/XTCE/20180204}'
types = {t.get('name'): t for t in tree.iter() if t.tag.endswith('ParameterType')}
parameters = {p.get('name'): types[p.get('parameterTypeRef')] for p in tree.iter(x + 'Parameter')}
containers = {c.get('name'): c for c in tree.iter(x + 'SequenceContainer')}


def read(container, at):
    """Returns the values of the entries of a container from byte `at` on, and where it ends."""
    result = {}
    for entry in container.iter(x + 'ParameterRefEntry'):
        name = entry.get('parameterRef')
        encoding = list(parameters[name])[0]
        n = int(encoding.get('sizeInBits')) // 8
        raw, at = data[at:at + n], at + n
        assert n == 1 or encoding.get('byteOrder') == 'leastSignificantByteFirst'
        if encoding.tag == x + 'FloatDataEncoding':
            result[name] = struct.unpack('<f' if n == 4 else '<d', raw)[0]
        else:
            result[name] = int.from_bytes(raw, 'little', signed=encoding.get('encoding') == 'twosComplement')
    return result, at


head, end = read(containers['header'], 0)
for c in containers.values():
    restriction = c.find('.//' + x + 'Comparison')
    if restriction is not None and int(restriction.get('value')) == head[restriction.get('parameterRef')]:
        body, end = read(c, end)
        print('xtce', [v for k, v in body.items() if k != 'crc'], end == len(data))
