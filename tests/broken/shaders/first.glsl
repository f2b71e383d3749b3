void main() { depth = aob_view_z(aob_pixel); }
