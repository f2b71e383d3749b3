void main() { depth = aob_fetch_finer(2 * aob_pixel); }
