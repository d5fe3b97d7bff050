//! Blocks of bytes with a checksum, by which a reader detects a block that is cut short or damaged.
//!
//! A block is the length of its content as eight bytes, little-endian, then the CRC-32 of the length and the content,
//! then the content.

use std::io::{self, Read, Write};

use crc32fast::Hasher;

/// Bytes before the content of a block: length and checksum.
pub const HEAD_BYTES: u64 = 12;

/// Writes a block.
pub fn write(to: &mut impl Write, content: &[u8]) -> io::Result<()> {
    let length = (content.len() as u64).to_le_bytes();
    to.write_all(&length)?;
    to.write_all(&checksum(&length, content).to_le_bytes())?;
    to.write_all(content)
}

/// Reads a block into `content`. False if the next `left` bytes do not begin with a complete, undamaged block.
pub fn read(from: &mut impl Read, left: u64, content: &mut Vec<u8>) -> io::Result<bool> {
    if left < HEAD_BYTES {
        return Ok(false);
    }
    let (mut length, mut crc) = ([0; 8], [0; 4]);
    from.read_exact(&mut length)?;
    from.read_exact(&mut crc)?;
    let size = u64::from_le_bytes(length);
    // a damaged length must not allocate memory
    if size > left - HEAD_BYTES {
        return Ok(false);
    }
    content.clear();
    from.take(size).read_to_end(content)?;
    Ok(content.len() as u64 == size && checksum(&length, content) == u32::from_le_bytes(crc))
}

/// CRC-32 of a block.
fn checksum(length: &[u8], content: &[u8]) -> u32 {
    let mut hasher = Hasher::new();
    hasher.update(length);
    hasher.update(content);
    hasher.finalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_whole(bytes: &[u8]) -> Option<Vec<u8>> {
        let mut content = Vec::new();
        read(&mut &bytes[..], bytes.len() as u64, &mut content).unwrap().then_some(content)
    }

    #[test]
    fn a_block_reads_back_and_a_cut_or_changed_block_does_not() {
        let mut block = Vec::new();
        write(&mut block, b"a net").unwrap();
        assert_eq!(read_whole(&block).as_deref(), Some(&b"a net"[..]));
        for end in 0..block.len() {
            assert_eq!(read_whole(&block[..end]), None, "{end}");
        }
        for bit in 0..8 * block.len() {
            let mut changed = block.clone();
            changed[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(read_whole(&changed), None, "bit {bit}");
        }
    }
}
